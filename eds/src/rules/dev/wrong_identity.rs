use crate::{
    Reading,
    diagnostic::Level,
    ir::{Address, Dictionary, Value},
    rules::{ReadingRule, Report, declare_rule},
    span::Spanned,
};

declare_rule! {
    /// ## What it does
    /// Finds a VendorNumber, ProductNumber or RevisionNumber that is not the default of the identity object (1018h:1 to 3).
    ///
    /// ## Why it matters
    /// Tools choose the file of a device by these numbers, from the one place or from the other: half of them find it.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// VendorNumber=0x0000009B
    ///
    /// [1018sub1]
    /// DefaultValue=0x0000009A
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1018sub1]
    /// DefaultValue=0x0000009B
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, `[DeviceInfo]`; CiA 301, object 1018h; CANchkEDS V130
    pub(crate) WrongIdentity { code: "DEV002", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for WrongIdentity {
    fn check(reading: &Reading, report: &mut Report) {
        let Some(device) = &reading.eds.device_info else {
            return;
        };
        let numbers = [
            (1, "VendorNumber", device.vendor_number),
            (2, "ProductNumber", device.product_number),
            (3, "RevisionNumber", device.revision_number),
        ];
        for (sub, keyword, number) in numbers {
            if let Some(number) = number {
                check_number(&reading.dictionary, sub, keyword, number, report);
            }
        }
    }
}

fn check_number(dictionary: &Dictionary, sub: u8, keyword: &str, number: Spanned<u32>, report: &mut Report) {
    let Some(entry) = dictionary.entry(Address::new(0x1018, sub)) else {
        return;
    };
    let Some(Value::Unsigned(value)) = entry.default else {
        return;
    };
    if value != u64::from(number.value) {
        let (ours, theirs) = (report.quote(number.span), report.quote(entry.spans.default));
        report
            .at(
                number.span,
                format!("{keyword} is {ours}, but 1018sub{sub} is {theirs}"),
            )
            .related(entry.spans.default, "the identity object")
            .help("write the same number in both places");
    }
}
