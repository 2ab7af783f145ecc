use crate::{
    diagnostic::Level,
    document::{Document, Problem},
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds entries whose keyword and value together are longer than 255 characters.
    ///
    /// ## Why it matters
    /// 255 is what the standard promises readers; those written in C cut the rest off, and a name or a value changes in silence.
    ///
    /// ## Example
    /// ```ini
    /// [Comments]
    /// Lines=1
    /// Line1=A text of 300 characters …
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [Comments]
    /// Lines=2
    /// Line1=A text of 200 characters …
    /// Line2=and the rest of it
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: sections and entries, CANchkEDS V23
    pub(crate) OverlongLine { code: "INI009", level: Level::Warn, since: "0.1.0" }
}

impl DocumentRule for OverlongLine {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::OverlongLine { at, characters } = *problem {
                report
                    .at(
                        at,
                        format!("keyword and value take {characters} characters; at most 255 are allowed"),
                    )
                    .help("shorten the value");
            }
        }
    }
}
