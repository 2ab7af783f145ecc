use crate::{
    diagnostic::Level,
    document::Keyword,
    model::{Eds, Problem},
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds keywords that need a value and have none. An empty default or limit is no finding: it says that there is none.
    ///
    /// ## Why it matters
    /// Readers take 0, or refuse the file.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// VendorNumber=
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceInfo]
    /// VendorNumber=0x25F
    /// ```
    ///
    /// ## Reference
    /// CANchkEDS V21, V29. An empty DataType is OBJ005, an empty AccessType OBJ007.
    pub(crate) EmptyValue { code: "EDS022", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for EmptyValue {
    fn check(eds: &Eds, report: &mut Report) {
        for problem in eds.problems() {
            match *problem {
                // These leave the device in doubt, and have rules of their own.
                Problem::EmptyValue {
                    keyword: Keyword::DataType | Keyword::AccessType,
                    ..
                } => {}
                Problem::EmptyValue { keyword, at, .. } => {
                    report
                        .at(at, format!("keyword {} has no value", keyword.name()))
                        .help("write the value, or remove the line");
                }
                _ => {}
            }
        }
    }
}
