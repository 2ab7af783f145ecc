use crate::{
    diagnostic::Level,
    document::{Document, Problem},
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds keywords that appear twice in one section.
    ///
    /// ## Why it matters
    /// Which of the two values counts is left to the reader: some take the first, some the last. A master and a generator may
    /// build two different devices from one file.
    ///
    /// ## Example
    /// ```ini
    /// [1018sub1]
    /// ParameterName=Vendor-ID
    /// DefaultValue=0x00000000
    /// DefaultValue=0x0000025F
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1018sub1]
    /// ParameterName=Vendor-ID
    /// DefaultValue=0x0000025F
    /// ```
    ///
    /// ## Reference
    /// CANchkEDS V25
    pub(crate) DuplicateKeyword { code: "INI003", level: Level::Deny, since: "0.1.0" }
}

impl DocumentRule for DuplicateKeyword {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::DuplicateKeyword { at, first } = *problem {
                report
                    .at(
                        at,
                        format!("keyword {} appears twice in this section", report.quote(at)),
                    )
                    .label("the second")
                    .related(first, "the first; it is the one that counts")
                    .help("remove one of them");
            }
        }
    }
}
