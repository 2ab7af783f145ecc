use crate::{
    diagnostic::Level,
    document::{Document, Problem},
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds lines that are neither a section's header, nor `Keyword=value`, nor a comment.
    ///
    /// ## Why it matters
    /// Readers disagree: some pass over the line, some glue it to the keyword below, Python's `configparser` (and with it
    /// python-canopen) refuses the whole file. Often the line is the rest of a value that was broken in two.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// in milliseconds
    /// DataType=0x0006
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time in milliseconds
    /// DataType=0x0006
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: sections and entries
    pub(crate) JunkLine { code: "INI001", level: Level::Warn, since: "0.1.0" }
}

impl DocumentRule for JunkLine {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            match *problem {
                Problem::JunkLine { at } => {
                    report
                        .at(at, format!("line {} has no `=`", report.quote(at)))
                        .help("join it to the line that it belongs to, or start it with `;` to make it a comment");
                }
                Problem::MissingKeyword { at } => {
                    report
                        .at(at, format!("line {} has no keyword before `=`", report.quote(at)))
                        .help("write the keyword, or start the line with `;` to make it a comment");
                }
                _ => {}
            }
        }
    }
}
