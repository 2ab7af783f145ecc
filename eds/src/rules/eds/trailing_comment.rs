use crate::{
    diagnostic::Level,
    fix::{Change, Fix},
    literal::Note,
    model::Eds,
    rules::{ModelRule, Report, Unusual, declare_rule, unusual},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds comments behind a value on the same line.
    ///
    /// ## Why it matters
    /// A comment has a line of its own in an EDS. Readers take it for a part of the value, and then cannot read the value.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// DataType=0x0006 ; UNSIGNED16
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// ; UNSIGNED16
    /// DataType=0x0006
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: comments
    pub(crate) TrailingComment { code: "EDS025", level: Level::Warn, since: "0.1.0", fixable: Always }
}

impl ModelRule for TrailingComment {
    fn check(eds: &Eds, report: &mut Report) {
        for Unusual { keyword, at, .. } in unusual(eds, Note::TrailingComment) {
            let (value, bare) = (report.quote(at), report.bare(at));
            let behind = Span::new(bare.end, at.end);
            let comment = report.text(behind).trim_start_matches([' ', '\t', '#', ';']);
            report
                .at(at, format!("{keyword} {value} has a comment after its value"))
                .help("move the comment to a line of its own that starts with `;`")
                .fix(Fix::replace(behind, "").and(Change::Comment {
                    at,
                    text: comment.to_owned(),
                }));
        }
    }
}
