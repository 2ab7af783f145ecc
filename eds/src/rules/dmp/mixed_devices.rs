use super::{answers::named, shown::shown};
use crate::{
    diagnostic::Level,
    dump::{Dump, Identity},
    ir::{Address, DataType, Dictionary},
    rules::{DumpRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds dumps whose `"device"`, noted when the dump began, is not the device that answered for 1000h or 1018h.
    ///
    /// ## Why it matters
    /// The dump was continued on another device, or the file was put together from two. What it says is of neither.
    ///
    /// ## Example
    /// ```json
    /// "device": { "serial_number": "0x00000007" },
    /// "1018sub4": "08 00 00 00"
    /// ```
    ///
    /// ## Reference
    /// docs/dump-format.md
    pub(crate) MixedDevices { code: "DMP018", level: Level::Deny, since: "0.1.0" }
}

impl DumpRule for MixedDevices {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        for (address, noted) in dump.device.iter().flat_map(facts) {
            let noted = noted.to_le_bytes();
            let Some(bytes) = dump.value(address).filter(|bytes| bytes.len() == 4 && *bytes != noted) else {
                continue;
            };
            let entry = dictionary.entry(address);
            let span = entry.map_or(Span::default(), |entry| entry.spans.section);
            let object = dictionary.object(address.index);
            let name = object.map_or_else(|| address.to_string(), |object| named(object, address));
            let (found, noted) = (shown(bytes, DataType::Unsigned32), shown(&noted, DataType::Unsigned32));
            report
                .at(
                    span,
                    format!("{name} answers {found}; the dump began on a device with {noted}"),
                )
                .help("take the dump again, of one device");
        }
    }
}

/// What the device told of itself, with the address where it tells it.
fn facts(device: &Identity) -> impl Iterator<Item = (Address, u32)> + use<> {
    let facts = [
        (Address::new(0x1000, 0), device.device_type),
        (Address::new(0x1018, 1), device.vendor_id),
        (Address::new(0x1018, 2), device.product_code),
        (Address::new(0x1018, 3), device.revision_number),
        (Address::new(0x1018, 4), device.serial_number),
    ];
    facts.into_iter().filter_map(|(address, fact)| Some((address, fact?)))
}
