use crate::{
    diagnostic::Level,
    document::{Document, Keyword, Problem},
    rules::similar,
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds keywords that the standard does not know.
    ///
    /// ## Why it matters
    /// Readers pass over them. Mostly it is a slip of the finger, and the value that was meant is lost; sometimes it is a vendor's
    /// addition, which belongs in a comment.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// DefaultVallue=1000
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
    /// CANchkEDS V24
    pub(crate) UnknownKeyword { code: "EDS003", level: Level::Warn, since: "0.1.0" }
}

impl DocumentRule for UnknownKeyword {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::UnknownKeyword { at } = *problem {
                let keyword = report.quote(at);
                let cure = match similar(document.text(at), Keyword::names()) {
                    Some(name) => format!("did you mean `{name}`?"),
                    None => "make the line a comment: start it with `;`".to_owned(),
                };
                report
                    .at(at, format!("keyword {keyword} is not known to CiA 306"))
                    .help(cure);
            }
        }
    }
}
