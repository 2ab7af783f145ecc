use crate::{
    Reading,
    diagnostic::Level,
    ir::Problem,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds arrays and records with sub-objects, but without sub-index 0.
    ///
    /// ## Why it matters
    /// Sub-index 0 says how many there are. A master that asks for it first gets an abort and gives up.
    ///
    /// ## Example
    /// ```ini
    /// [1003]
    /// ParameterName=Pre-defined error field
    /// ObjectType=0x8
    /// SubNumber=1
    ///
    /// [1003sub1]
    /// ParameterName=Standard error field 1
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1003]
    /// ParameterName=Pre-defined error field
    /// ObjectType=0x8
    /// SubNumber=2
    ///
    /// [1003sub0]
    /// ParameterName=Number of errors
    ///
    /// [1003sub1]
    /// ParameterName=Standard error field 1
    /// ```
    ///
    /// ## Reference
    /// CiA 301, sub-index 0; CANchkEDS V14
    pub(crate) MissingSubIndexZero { code: "OBJ009", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for MissingSubIndexZero {
    fn check(reading: &Reading, report: &mut Report) {
        for problem in &reading.problems {
            if let Problem::MissingSubZero { index, highest, at } = *problem {
                report
                    .at(at, format!("object {index:04X}h has no sub-index 0"))
                    .help(format!("write a section [{index:04X}sub0] with DefaultValue={highest}"));
            }
        }
    }
}
