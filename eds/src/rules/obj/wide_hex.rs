use super::words::more;
use crate::{
    diagnostic::Level,
    ir::DataType,
    literal::Note,
    model::{Eds, Expected},
    rules::{ModelRule, Report, Unusual, declare_rule, unusual},
};

declare_rule! {
    /// ## What it does
    /// Finds hex numbers with more digits than their data type has. One finding a file, at the first of them.
    ///
    /// ## Why it matters
    /// The value fits, and every reader finds it. But the digits promise another type; often the DataType was changed later.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// DataType=0x0006
    /// DefaultValue=0x00000064
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// DataType=0x0006
    /// DefaultValue=0x0064
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: numbers
    pub(crate) WideHex { code: "OBJ012", level: Level::Note, since: "0.1.0" }
}

impl ModelRule for WideHex {
    fn check(eds: &Eds, report: &mut Report) {
        let mut found = unusual(eds, Note::WideHex);
        if let Some(Unusual { keyword, expected, at }) = found.next() {
            let cure = match expected {
                Expected::Value(data_type) => narrow(report.text(at), data_type),
                _ => None,
            };
            let (value, more) = (report.quote(at), more(found.count()));
            report
                .at(at, format!("{keyword} {value} has more digits than its type{more}"))
                .help(cure.unwrap_or_else(|| "leave out leading zeros".into()));
        }
    }
}

fn narrow(text: &str, data_type: DataType) -> Option<String> {
    let digits = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X"))?;
    let wide = digits.len().checked_sub(data_type.bytes()? * 2)?;
    let (zeros, digits) = digits.split_at_checked(wide)?;
    zeros
        .bytes()
        .all(|byte| byte == b'0')
        .then(|| format!("write `0x{digits}`"))
}
