use crate::{
    diagnostic::Level,
    document::{Document, Problem},
    fix::Fix,
    rules::{DocumentRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds section headers that do not start in column 1.
    ///
    /// ## Why it matters
    /// Readers that follow the standard to the letter do not see the section and add its keywords to the one above.
    ///
    /// ## Example
    /// ```ini
    ///   [1017]
    /// ParameterName=Producer heartbeat time
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// ```
    ///
    /// ## Reference
    /// CANchkEDS V3
    pub(crate) IndentedHeader { code: "INI007", level: Level::Warn, since: "0.1.0", fixable: Always }
}

impl DocumentRule for IndentedHeader {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::IndentedHeader { at } = *problem {
                let line = document.source().line_span(document.source().line_column(at).line);
                report
                    .at(at, format!("header {} does not start in column 1", report.quote(at)))
                    .help("remove the blanks before it")
                    .fix(Fix::replace(Span::new(line.start, at.start), ""));
            }
        }
    }
}
