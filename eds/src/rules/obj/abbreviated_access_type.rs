use crate::{
    diagnostic::Level,
    fix::Fix,
    literal::Note,
    model::Eds,
    rules::{ModelRule, Report, Unusual, declare_rule, unusual},
};

declare_rule! {
    /// ## What it does
    /// Finds an AccessType that is `R` for `ro` or `W` for `wo`.
    ///
    /// ## Why it matters
    /// The standard does not know these: most readers refuse the file or take the value for something else.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// AccessType=R
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// AccessType=ro
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, AccessType; CANchkEDS V29
    pub(crate) AbbreviatedAccessType { code: "OBJ024", level: Level::Warn, since: "0.1.0", fixable: Always }
}

impl ModelRule for AbbreviatedAccessType {
    fn check(eds: &Eds, report: &mut Report) {
        for Unusual { keyword, at, .. } in unusual(eds, Note::Abbreviation) {
            let text = report.text(at);
            let word = if text.starts_with(['r', 'R']) { "ro" } else { "wo" };
            let (value, bare) = (report.quote(at), report.bare(at));
            report
                .at(at, format!("{keyword} {value} is not a word of the standard"))
                .help(format!("write `{word}`"))
                .fix(Fix::replace(bare, word));
        }
    }
}
