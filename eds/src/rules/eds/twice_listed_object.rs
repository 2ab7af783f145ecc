use crate::{
    Reading,
    diagnostic::Level,
    ir::Problem,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects that are twice in a list, or in two lists.
    ///
    /// ## Why it matters
    /// Readers count the object twice, or refuse the file.
    ///
    /// ## Example
    /// ```ini
    /// [MandatoryObjects]
    /// SupportedObjects=3
    /// 1=0x1000
    /// 2=0x1001
    /// 3=0x1018
    ///
    /// [OptionalObjects]
    /// SupportedObjects=2
    /// 1=0x1017
    /// 2=0x1017
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=1
    /// 1=0x1017
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, object lists; CANchkEDS V37
    pub(crate) TwiceListedObject { code: "EDS015", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for TwiceListedObject {
    fn check(reading: &Reading, report: &mut Report) {
        for problem in &reading.problems {
            if let Problem::ListedTwice { index, at, first } = *problem {
                report
                    .at(at, format!("object {index:04X}h is listed a second time"))
                    .label("the second time")
                    .related(first, "the first time")
                    .help("keep it in the list that it belongs in");
            }
        }
    }
}
