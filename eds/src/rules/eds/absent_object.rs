use crate::{
    Reading,
    diagnostic::Level,
    ir::Problem,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects that are in a list but have no section.
    ///
    /// ## Why it matters
    /// The file says that the device has the object, and nothing about it. A generator cannot make it, a master does not know its
    /// type.
    ///
    /// ## Example
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=1
    /// 1=0x1017
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=1
    /// 1=0x1017
    ///
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// ObjectType=0x7
    /// DataType=0x0006
    /// AccessType=rw
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, object lists
    pub(crate) AbsentObject { code: "EDS007", level: Level::Deny, since: "0.1.0" }
}

impl ReadingRule for AbsentObject {
    fn check(reading: &Reading, report: &mut Report) {
        for problem in &reading.problems {
            if let Problem::AbsentObject { index, at, .. } = *problem {
                report
                    .at(at, format!("object {index:04X}h is listed, but has no section"))
                    .help(format!(
                        "write a section [{index:04X}], or take the object off the list"
                    ));
            }
        }
    }
}
