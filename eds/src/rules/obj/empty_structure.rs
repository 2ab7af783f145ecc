use crate::{
    Reading,
    diagnostic::Level,
    ir::Problem,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds arrays and records without a single sub-object.
    ///
    /// ## Why it matters
    /// Their values are at their sub-objects: such an object has nothing to read or write.
    ///
    /// ## Example
    /// ```ini
    /// [1018]
    /// ParameterName=Identity object
    /// ObjectType=0x9
    /// SubNumber=0
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1018]
    /// ParameterName=Identity object
    /// ObjectType=0x9
    /// SubNumber=2
    ///
    /// [1018sub0]
    /// …
    /// [1018sub1]
    /// …
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, SubNumber and CompactSubObj; CANchkEDS V34
    pub(crate) EmptyStructure { code: "OBJ018", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for EmptyStructure {
    fn check(reading: &Reading, report: &mut Report) {
        for problem in &reading.problems {
            if let Problem::NoSubs { index, at } = *problem {
                report
                    .at(
                        at,
                        format!("object {index:04X}h is an array or record, but has no sub-objects"),
                    )
                    .help("write sections for its sub-objects, or fix the ObjectType");
            }
        }
    }
}
