use crate::{
    Reading,
    diagnostic::Level,
    ir::Problem,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds a CompactSubObj above 254.
    ///
    /// ## Why it matters
    /// Sub-index 255 is kept for the structure of the object: the highest that a value can have is 254.
    ///
    /// ## Example
    /// ```ini
    /// [1003]
    /// ParameterName=Pre-defined error field
    /// CompactSubObj=255
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1003]
    /// ParameterName=Pre-defined error field
    /// CompactSubObj=254
    /// ```
    ///
    /// ## Reference
    /// CiA 301, sub-index FFh
    pub(crate) TooManySubObjects { code: "OBJ019", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for TooManySubObjects {
    fn check(reading: &Reading, report: &mut Report) {
        for problem in &reading.problems {
            if let Problem::TooManySubs { index, at } = *problem {
                let value = report.quote(at);
                report
                    .at(at, format!("CompactSubObj {value} of {index:04X}h is above 254"))
                    .help("write at most 254");
            }
        }
    }
}
