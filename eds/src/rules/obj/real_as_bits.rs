use crate::{
    diagnostic::Level,
    fix::Fix,
    ir::{DataType, Value},
    literal::{self, Note},
    model::{Eds, Expected},
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
    pub(crate) RealAsBits { code: "OBJ015", level: Level::Note, since: "0.1.0", fixable: Sometimes }
}

impl ModelRule for RealAsBits {
    fn check(eds: &Eds, report: &mut Report) {
        for Unusual { keyword, expected, at } in unusual(eds, Note::RealAsBits) {
            let bare = report.bare(at);
            let decimal = match expected {
                Expected::Value(data_type) => decimal(report.text(bare), data_type),
                _ => None,
            };
            let cure = decimal.as_ref().map(|decimal| format!("write `{decimal}`"));
            let value = report.quote(at);
            report
                .at(at, format!("{keyword} {value} is a real number given by its bits"))
                .help(cure.unwrap_or_else(|| "write it in decimal".into()))
                .fix(decimal.map(|decimal| Fix::replace(bare, decimal)));
        }
    }
}

/// The shortest decimal number that is these bits; infinity and NaN have none.
fn decimal(text: &str, data_type: DataType) -> Option<String> {
    match literal::value(text, data_type).ok()?.value {
        Value::Real32(value) if value.is_finite() => Some(format!("{value:?}")),
        Value::Real64(value) if value.is_finite() => Some(format!("{value:?}")),
        _ => None,
    }
}
