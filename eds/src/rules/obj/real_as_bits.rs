use crate::{
    diagnostic::Level,
    literal::Note,
    model::Eds,
    rules::{ModelRule, Report, Unusual, declare_rule, unusual},
};

declare_rule! {
    /// ## What it does
    /// Finds real numbers given as the hex pattern of their bits: 0x3F800000 is 1.0.
    ///
    /// ## Why it matters
    /// A reader that expects a decimal number cannot read it, or takes it for 1065353216.
    ///
    /// ## Example
    /// ```ini
    /// [2000]
    /// DataType=0x0008
    /// DefaultValue=0x3F800000
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [2000]
    /// DataType=0x0008
    /// DefaultValue=1.0
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: numbers
    pub(crate) RealAsBits { code: "OBJ015", level: Level::Note, since: "0.1.0" }
}

impl ModelRule for RealAsBits {
    fn check(eds: &Eds, report: &mut Report) {
        for Unusual { keyword, at, .. } in unusual(eds, Note::RealAsBits) {
            let value = report.quote(at);
            report
                .at(at, format!("{keyword} {value} is a real number given by its bits"))
                .help("write it in decimal");
        }
    }
}
