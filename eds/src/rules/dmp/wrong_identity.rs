use super::{answers::answered, shown::shown};
use crate::{
    diagnostic::Level,
    dump::Dump,
    ir::{AccessType, Address, DataType, Dictionary, Entry, Value},
    rules::{DumpRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds a device type (1000h), Vendor-ID, product code or revision number (1018h:1 to 3) that is not the file's: not the
    /// object's default or, where it has none, not VendorNumber, ProductNumber or RevisionNumber of `[DeviceInfo]`. The serial
    /// number (1018h:4) has to be a DCF's LSS_SerialNumber, or the file's where that is a constant and not 0.
    ///
    /// ## Why it matters
    /// This is not the device that the file describes, or another revision of it. A master that checks 1F84h to 1F88h refuses
    /// to start it.
    ///
    /// ## Example
    /// ```ini
    /// [1018sub2]
    /// DefaultValue=0x00000001
    /// ```
    /// for a device that answers `02 00 00 00`.
    ///
    /// ## Reference
    /// CiA 301, objects 1000h and 1018h; CiA 306-1, `[DeviceInfo]`; CANchkEDS V130
    pub(crate) WrongIdentity { code: "DMP007", level: Level::Deny, since: "0.1.0" }
}

impl DumpRule for WrongIdentity {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        for answer in answered(dictionary, dump).filter(|answer| is_identity(answer.entry.address)) {
            let Some((expected, origin)) = expected_identity(dictionary, answer.entry) else {
                continue;
            };
            let expected = expected.to_bytes(NUMBER, None);
            if answer.fits() && answer.bytes != expected {
                let (found, expected) = (shown(answer.bytes, NUMBER), shown(&expected, NUMBER));
                let message = format!("{} answers {found}; {origin} says {expected}", answer.named());
                report
                    .at(answer.entry.spans.default, message)
                    .help("take the file of this device and firmware");
            }
        }
    }
}

const NUMBER: DataType = DataType::Unsigned32;

/// Whether the value says who the device is.
pub(super) const fn is_identity(address: Address) -> bool {
    matches!((address.index, address.sub), (0x1000, 0) | (0x1018, 1..=4))
}

/// What the identity has to be, and who says so.
fn expected_identity(dictionary: &Dictionary, entry: &Entry) -> Option<(Value, &'static str)> {
    let default = entry.default.clone().filter(|_| !is_any_serial_number(entry));
    let default = default.map(|default| (default, "the file"));
    default.or_else(|| from_header(dictionary, entry.address))
}

/// Whether it is a serial number that the file leaves open: not a constant, or 0.
fn is_any_serial_number(entry: &Entry) -> bool {
    let is_open = entry.access != AccessType::Const || entry.default == Some(Value::Unsigned(0));
    entry.address == Address::new(0x1018, 4) && is_open
}

/// What the sections about the device say, with the name of the keyword.
fn from_header(dictionary: &Dictionary, address: Address) -> Option<(Value, &'static str)> {
    let device = &dictionary.device;
    let commissioning = dictionary.commissioning.as_ref();
    // Tools write 0 where they do not know it.
    let serial_number = commissioning
        .and_then(|commissioning| commissioning.lss_serial_number)
        .filter(|&number| number != 0);
    let (number, keyword) = match (address.index, address.sub) {
        (0x1018, 1) => (device.vendor_number, "VendorNumber"),
        (0x1018, 2) => (device.product_number, "ProductNumber"),
        (0x1018, 3) => (device.revision_number, "RevisionNumber"),
        (0x1018, 4) => (serial_number, "LSS_SerialNumber"),
        _ => (None, ""),
    };
    Some((Value::Unsigned(u64::from(number?)), keyword))
}
