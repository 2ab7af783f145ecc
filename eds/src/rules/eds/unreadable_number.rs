use crate::{
    diagnostic::Level,
    document::Keyword,
    literal::Fault,
    model::{Eds, Expected, Problem},
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds numbers and flags that cannot be read, or that are larger than their keyword allows. Values of objects have rules of
    /// their own in family OBJ.
    ///
    /// ## Why it matters
    /// Readers take 0, pass over the keyword, or refuse the file.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// VendorNumber=25F
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceInfo]
    /// VendorNumber=0x25F
    /// ```
    ///
    /// ## Reference
    /// CANchkEDS V21, V22
    pub(crate) UnreadableNumber { code: "EDS004", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for UnreadableNumber {
    fn check(eds: &Eds, report: &mut Report) {
        for problem in eds.problems() {
            let Problem::Unreadable {
                keyword,
                expected,
                fault,
                at,
            } = *problem
            else {
                continue;
            };
            // An unreadable type is OBJ005, an octal number EDS013.
            let elsewhere = keyword == Keyword::DataType || fault == Fault::NotOctal;
            let Some(range) = range(expected).filter(|_| !elsewhere) else {
                continue;
            };
            let fact = match fault {
                Fault::OutOfRange => "is out of range",
                _ => "is not a number",
            };
            let value = report.quote(at);
            report
                .at(at, format!("{} {value} {fact}", keyword.name()))
                .help(format!("write {range}"));
        }
    }
}

/// What a keyword that is no object's value may be.
const fn range(expected: Expected) -> Option<&'static str> {
    match expected {
        Expected::Flag => Some("0 or 1"),
        Expected::Unsigned8 => Some("a number from 0 to 255, such as 16 or 0x10"),
        Expected::Unsigned16 => Some("a number from 0 to 65535, such as 16 or 0x10"),
        Expected::Unsigned32 => Some("a number from 0 to 4294967295, such as 16 or 0x10"),
        Expected::IndexRange => Some("two indices, such as 0xA080-0xA0BF"),
        Expected::Count => Some("a count, or `0;` and a number of bits"),
        Expected::PpOffset => Some("an offset, or an offset, a comma and a difference"),
        _ => None,
    }
}
