use crate::{
    diagnostic::Level,
    document::{Document, Problem, SectionName},
    rules::similar,
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds sections that the standard does not know.
    ///
    /// ## Why it matters
    /// Readers pass over them with all that they say. Mostly the name is misspelled; sometimes it is a vendor's addition, which no
    /// other tool understands.
    ///
    /// ## Example
    /// ```ini
    /// [OptionalObject]
    /// SupportedObjects=1
    /// 1=0x1017
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
    /// CANchkEDS W1
    pub(crate) UnknownSection { code: "EDS010", level: Level::Warn, since: "0.1.0" }
}

impl DocumentRule for UnknownSection {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::UnknownSection { at } = *problem {
                let section = report.quote(at);
                let cure = match similar(document.text(at), SectionName::names()) {
                    Some(name) => format!("did you mean [{name}]?"),
                    None => "remove it, or make it comments".to_owned(),
                };
                report
                    .at(at, format!("section {section} is not known to CiA 306"))
                    .help(cure);
            }
        }
    }
}
