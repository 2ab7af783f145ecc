use crate::{
    diagnostic::Level,
    document::{Document, Problem},
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds sections whose name was used before in the file.
    ///
    /// ## Why it matters
    /// Which of the two counts is left to the reader: some take the first, some the last, some mix both. A master and a
    /// generator may build two different devices from one file.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// DefaultValue=0
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// DefaultValue=1000
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// DefaultValue=1000
    /// ```
    ///
    /// ## Reference
    /// CANchkEDS V4
    pub(crate) DuplicateSection { code: "INI002", level: Level::Deny, since: "0.1.0" }
}

impl DocumentRule for DuplicateSection {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::DuplicateSection { at, first } = *problem {
                report
                    .at(at, format!("section {} appears a second time", report.quote(at)))
                    .label("the second")
                    .related(first, "the first; it is the one that counts")
                    .help("merge the two into one");
            }
        }
    }
}
