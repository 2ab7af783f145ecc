use crate::{
    diagnostic::Level,
    model::{Eds, Problem},
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds limits of values that have no order: texts, bytes, times.
    ///
    /// ## Why it matters
    /// No reader can do anything with them.
    ///
    /// ## Example
    /// ```ini
    /// [1008]
    /// DataType=0x0009
    /// LowLimit=0
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1008]
    /// DataType=0x0009
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, LowLimit and HighLimit
    pub(crate) UnorderedLimit { code: "OBJ016", level: Level::Note, since: "0.1.0" }
}

impl ModelRule for UnorderedLimit {
    fn check(eds: &Eds, report: &mut Report) {
        for problem in eds.problems() {
            if let Problem::LimitOfUnorderedType { keyword, data_type, at } = *problem {
                report
                    .at(at, format!("{} means nothing for {}", keyword.name(), data_type.name()))
                    .help("remove it");
            }
        }
    }
}
