use super::words::unreadable;

use crate::{
    diagnostic::Level,
    document::Keyword,
    literal::Fault,
    model::{Eds, Expected, Problem},
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds limits that are no value of the object's data type.
    ///
    /// ## Why it matters
    /// The limit is lost: a reader passes over it, cuts off what does not fit, or refuses the file.
    ///
    /// ## Example
    /// ```ini
    /// [2000]
    /// DataType=0x0006
    /// HighLimit=65536
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [2000]
    /// DataType=0x0006
    /// HighLimit=65535
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, LowLimit and HighLimit; CANchkEDS V21, V22
    pub(crate) LimitOfWrongType { code: "OBJ004", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for LimitOfWrongType {
    fn check(eds: &Eds, report: &mut Report) {
        for problem in eds.problems() {
            match *problem {
                Problem::Unreadable {
                    fault: Fault::NotOctal, ..
                } => {}
                Problem::Unreadable {
                    keyword: keyword @ (Keyword::LowLimit | Keyword::HighLimit),
                    expected: Expected::Value(data_type),
                    fault,
                    at,
                } => {
                    let (fact, cure) = unreadable(fault, data_type);
                    let value = report.quote(at);
                    report.at(at, format!("{} {value} {fact}", keyword.name())).help(cure);
                }
                _ => {}
            }
        }
    }
}
