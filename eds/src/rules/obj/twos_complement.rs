use crate::{
    diagnostic::Level,
    ir::{DataType, Value},
    literal::{self, Note},
    model::{Eds, Expected},
    rules::{ModelRule, Report, Unusual, declare_rule, unusual},
};

declare_rule! {
    /// ## What it does
    /// Finds hex numbers of signed types that stand for a negative value by their top bit: 0xFF of INTEGER8 is -1.
    ///
    /// ## Why it matters
    /// The standard writes negative numbers with a sign. Some readers take the number for a large positive one, find it out of
    /// range, and refuse the file.
    ///
    /// ## Example
    /// ```ini
    /// [607D]
    /// DataType=0x0004
    /// DefaultValue=0x80000000
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [607D]
    /// DataType=0x0004
    /// DefaultValue=-2147483648
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: numbers
    pub(crate) TwosComplement { code: "OBJ011", level: Level::Note, since: "0.1.0" }
}

impl ModelRule for TwosComplement {
    fn check(eds: &Eds, report: &mut Report) {
        for Unusual { keyword, expected, at } in unusual(eds, Note::TwosComplement) {
            let cure = match (expected, report.text(at)) {
                (Expected::Value(data_type), text) => decimal(text, data_type),
                _ => None,
            };
            let value = report.quote(at);
            report
                .at(at, format!("{keyword} {value} is a negative number in hex"))
                .help(cure.unwrap_or_else(|| "write it in decimal, with a sign".into()));
        }
    }
}

fn decimal(text: &str, data_type: DataType) -> Option<String> {
    match literal::value(text, data_type).ok()?.value {
        Value::Integer(value) => Some(format!("write `{value}`")),
        _ => None,
    }
}
