use super::words::FIRST_OF_VENDORS;

use crate::{
    Reading,
    diagnostic::Level,
    ir::Problem,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds values whose DataType is defined by the vendor or by a device profile (40h and above).
    ///
    /// ## Why it matters
    /// Other tools do not know the type: they treat the value as a number of bytes without a meaning, or refuse it.
    ///
    /// ## Example
    /// ```ini
    /// [2000]
    /// ObjectType=0x7
    /// DataType=0x0040
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [2000]
    /// ObjectType=0x7
    /// DataType=0x000F
    /// ```
    ///
    /// ## Reference
    /// CiA 301, data types; CANchkEDS W23
    pub(crate) ForeignDataType { code: "OBJ006", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for ForeignDataType {
    fn check(reading: &Reading, report: &mut Report) {
        for problem in &reading.problems {
            match *problem {
                Problem::UnknownDataType { data_type, at, .. } if data_type >= FIRST_OF_VENDORS => {
                    let value = report.quote(at);
                    report
                        .at(at, format!("DataType {value} is no data type of CiA 301"))
                        .help("use a data type of CiA 301; DOMAIN (0x000F) takes any bytes");
                }
                _ => {}
            }
        }
    }
}
