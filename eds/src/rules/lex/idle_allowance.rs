use crate::{
    diagnostic::Level,
    rules::{AllowanceRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds comments `; lexican: allow(CODE)` that allow nothing: the rule finds nothing there.
    ///
    /// ## Why it matters
    /// What was to be allowed has been mended, or stands somewhere else; the comment would hide the next fault of that kind.
    ///
    /// ## Example
    /// ```ini
    /// ; lexican: allow(OBJ003)
    /// DefaultValue=0x10
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// DefaultValue=0x10
    /// ```
    ///
    /// ## Reference
    /// docs/config.md
    pub(crate) IdleAllowance { code: "LEX002", level: Level::Note, since: "0.1.0" }
}

impl AllowanceRule for IdleAllowance {
    fn check(idle: &[Span], report: &mut Report) {
        for at in idle {
            let name = report.text(*at);
            report
                .at(*at, format!("{name} finds nothing that this comment allows"))
                .help(format!("take `{name}` out of the comment"));
        }
    }
}
