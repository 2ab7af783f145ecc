use crate::{
    diagnostic::Level,
    literal::Note,
    model::Eds,
    rules::{ModelRule, Report, Unusual, declare_rule, unusual},
};

declare_rule! {
    /// ## What it does
    /// Finds numbers with a suffix of the language C: `100UL`, `0x1000LL`, `1.5f`.
    ///
    /// ## Why it matters
    /// An EDS knows no suffixes: most readers cannot read the number.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// DefaultValue=1000U
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// DefaultValue=1000
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: numbers; CANchkEDS V21
    pub(crate) CSuffix { code: "EDS026", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for CSuffix {
    fn check(eds: &Eds, report: &mut Report) {
        for Unusual { keyword, at, .. } in unusual(eds, Note::Suffix) {
            let value = report.quote(at);
            report
                .at(at, format!("{keyword} {value} has a suffix of C"))
                .help("leave out the suffix");
        }
    }
}
