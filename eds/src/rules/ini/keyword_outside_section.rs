use crate::{
    diagnostic::Level,
    document::{Document, Problem},
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds `Keyword=value` before the first section.
    ///
    /// ## Why it matters
    /// It belongs to nothing. Readers pass over it or refuse the file; most often the section's header above it was lost.
    ///
    /// ## Example
    /// ```ini
    /// FileName=pump.eds
    /// [FileInfo]
    /// EDSVersion=4.0
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [FileInfo]
    /// FileName=pump.eds
    /// EDSVersion=4.0
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: sections and entries
    pub(crate) KeywordOutsideSection { code: "INI005", level: Level::Warn, since: "0.1.0" }
}

impl DocumentRule for KeywordOutsideSection {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::KeywordOutsideSection { at } = *problem {
                report
                    .at(
                        at,
                        format!("keyword {} comes before the first section", report.quote(at)),
                    )
                    .help("move it below the header of its section");
            }
        }
    }
}
