use super::words::unreadable;

use crate::{
    diagnostic::Level,
    document::Keyword,
    ir::DataType,
    literal::Fault,
    model::{Eds, Expected, Problem},
    rules::{ModelRule, Report, declare_rule, value_name},
};

declare_rule! {
    /// ## What it does
    /// Finds values of objects (DefaultValue, ParameterValue, and those of the compact form) that are no value of the object's data
    /// type.
    ///
    /// ## Why it matters
    /// Nobody knows the value. Readers take 0, cut off what does not fit, or refuse the file.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// DataType=0x0006
    /// DefaultValue=100 ms
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// DataType=0x0006
    /// DefaultValue=100
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, DefaultValue; CANchkEDS V21, V22
    pub(crate) ValueOfWrongType { code: "OBJ003", level: Level::Deny, since: "0.1.0" }
}

impl ModelRule for ValueOfWrongType {
    fn check(eds: &Eds, report: &mut Report) {
        for problem in eds.problems() {
            match *problem {
                Problem::Unreadable {
                    keyword: Keyword::LowLimit | Keyword::HighLimit,
                    ..
                }
                | Problem::Unreadable {
                    expected: Expected::Value(DataType::Domain),
                    ..
                }
                | Problem::Unreadable {
                    fault: Fault::NotOctal, ..
                } => {}
                Problem::Unreadable {
                    keyword,
                    expected: Expected::Value(data_type),
                    fault,
                    at,
                } => {
                    let (fact, cure) = unreadable(fault, data_type);
                    let value = report.quote(at);
                    report
                        .at(at, format!("{} {value} {fact}", value_name(keyword)))
                        .help(cure);
                }
                _ => {}
            }
        }
    }
}
