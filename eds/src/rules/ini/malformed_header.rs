use crate::{
    diagnostic::Level,
    document::{Document, Problem},
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds section headers without their closing bracket.
    ///
    /// ## Why it matters
    /// What follows is lost, or worse, is taken as part of the section above.
    ///
    /// ## Example
    /// ```ini
    /// [1018sub1
    /// ParameterName=Vendor-ID
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1018sub1]
    /// ParameterName=Vendor-ID
    /// ```
    ///
    /// ## Reference
    /// CANchkEDS V2
    pub(crate) MalformedHeader { code: "INI006", level: Level::Deny, since: "0.1.0" }
}

impl DocumentRule for MalformedHeader {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::MalformedHeader { at } = *problem {
                report
                    .at(at, format!("header {} has no closing bracket", report.quote(at)))
                    .label("what follows belongs to no section")
                    .help("write `]` behind the section's name");
            }
        }
    }
}
