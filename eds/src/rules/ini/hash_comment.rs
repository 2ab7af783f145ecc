use crate::{
    diagnostic::Level,
    document::{Document, Problem},
    fix::Fix,
    rules::{DocumentRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds lines that start with `#`.
    ///
    /// ## Why it matters
    /// A comment starts with `;` in an EDS. A reader that knows no other takes the line for a keyword, or refuses the file.
    ///
    /// ## Example
    /// ```ini
    /// [1003sub1]
    /// # the newest error
    /// ParameterName=Standard error field 1
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1003sub1]
    /// ; the newest error
    /// ParameterName=Standard error field 1
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: comments
    pub(crate) HashComment { code: "INI013", level: Level::Warn, since: "0.1.0", fixable: Always }
}

impl DocumentRule for HashComment {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::HashComment { at } = *problem {
                report
                    .at(at, "a comment starts with `;`, not with `#`")
                    .help("write `;` in place of `#`")
                    .fix(Fix::replace(Span::new(at.start, at.start + 1), ";"));
            }
        }
    }
}
