use crate::{
    Reading,
    diagnostic::Level,
    ir::Problem,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds lines of `[xxxxName]`, `[xxxxValue]` and `[xxxxDenotation]` for a sub-object that the object does not have.
    ///
    /// ## Why it matters
    /// The name or value is lost.
    ///
    /// ## Example
    /// ```ini
    /// [1003]
    /// ParameterName=Pre-defined error field
    /// CompactSubObj=2
    ///
    /// [1003Name]
    /// NrOfEntries=1
    /// 3=The oldest error
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1003]
    /// ParameterName=Pre-defined error field
    /// CompactSubObj=3
    ///
    /// [1003Name]
    /// NrOfEntries=1
    /// 3=The oldest error
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, CompactSubObj; CANchkEDS V40
    pub(crate) LineWithoutSubObject { code: "EDS028", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for LineWithoutSubObject {
    fn check(reading: &Reading, report: &mut Report) {
        for problem in &reading.problems {
            if let Problem::LineOfNoSub { index, number, at } = *problem {
                report
                    .at(at, format!("object {index:04X}h has no sub-index {number}"))
                    .help("fix the number, or CompactSubObj of the object");
            }
        }
    }
}
