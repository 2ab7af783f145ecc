use crate::{
    diagnostic::Level,
    document::{Document, Problem},
    fix::{Change, Fix},
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds files whose lines do not all end alike: some in CR LF, some in LF. One finding a file, at the first line that differs.
    ///
    /// ## Why it matters
    /// Every tool of today reads both. But tools that compare or merge files see changes where there are none.
    ///
    /// ## Example
    /// A file of a Windows editor into which a script on Linux wrote some lines.
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: lines
    pub(crate) MixedLineEnds { code: "INI012", level: Level::Note, since: "0.1.0", fixable: Always }
}

impl DocumentRule for MixedLineEnds {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::MixedLineEnds { at } = *problem {
                report
                    .at(at, "this line does not end like the line before it")
                    .help("save the file with the same line end everywhere, best CR LF")
                    .fix(Fix::new(Change::LineEnds));
            }
        }
    }
}
