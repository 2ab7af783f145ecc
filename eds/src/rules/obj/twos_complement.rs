use crate::{
    diagnostic::Level,
    document::Keyword,
    fix::Fix,
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
    pub(crate) TwosComplement { code: "OBJ011", level: Level::Note, since: "0.1.0", fixable: Sometimes }
}

impl ModelRule for TwosComplement {
    fn check(eds: &Eds, report: &mut Report) {
        for Unusual { keyword, expected, at } in unusual(eds, Note::TwosComplement) {
            let bare = report.bare(at);
            let decimal = match expected {
                Expected::Value(data_type) => decimal(report.text(bare), data_type),
                _ => None,
            };
            let cure = decimal.as_ref().map(|decimal| format!("write `{decimal}`"));
            // `HighLimit=0xFF` of an INTEGER8 may well be a slip: of the type, not of the limit.
            let is_high = keyword == Keyword::HighLimit.name();
            let value = report.quote(at);
            report
                .at(at, format!("{keyword} {value} is a negative number in hex"))
                .help(cure.unwrap_or_else(|| "write it in decimal, with a sign".into()))
                .fix(decimal.filter(|_| !is_high).map(|decimal| Fix::replace(bare, decimal)));
        }
    }
}

fn decimal(text: &str, data_type: DataType) -> Option<String> {
    match literal::value(text, data_type).ok()?.value {
        Value::Integer(value) => Some(value.to_string()),
        _ => None,
    }
}
