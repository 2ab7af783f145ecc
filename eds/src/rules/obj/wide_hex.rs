use crate::{
    diagnostic::Level,
    fix::{Change, Fix},
    literal::Note,
    model::{Eds, Expected},
    rules::{ModelRule, Report, Unusual, declare_rule, more, unusual},
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
    pub(crate) WideHex { code: "OBJ012", level: Level::Note, since: "0.1.0", fixable: Sometimes }
}

impl ModelRule for WideHex {
    fn check(eds: &Eds, report: &mut Report) {
        let found = unusual(eds, Note::WideHex);
        let Some(Unusual { keyword, at, .. }) = found.clone().next() else {
            return;
        };
        let narrow = |found: Unusual| narrow(report, &found);
        let changes: Option<Vec<Change>> = found.clone().map(narrow).collect();
        let cure = match changes.as_deref() {
            Some([Change::Replace { text, .. }, ..]) => format!("write `{text}`"),
            _ => "leave out leading zeros".to_owned(),
        };
        let (value, more) = (report.quote(at), more(found.count() - 1));
        report
            .at(at, format!("{keyword} {value} has more digits than its type{more}"))
            .help(cure)
            .fix(changes.map(Fix::from_iter));
    }
}

/// The value, or the number in its formula, with as many digits as its type has.
fn narrow(report: &Report, found: &Unusual) -> Option<Change> {
    let Expected::Value(data_type) = found.expected else {
        return None;
    };
    let at = report.bare(found.at);
    let text = report.text(at);
    let start = text.find("0x").or_else(|| text.find("0X"))? + 2;
    let (before, rest) = text.split_at_checked(start)?;
    let length = rest.bytes().take_while(u8::is_ascii_hexdigit).count();
    let (digits, after) = rest.split_at_checked(length)?;
    let (zeros, digits) = digits.split_at_checked(length.checked_sub(data_type.bytes()? * 2)?)?;
    let text = format!("{before}{digits}{after}");
    zeros
        .bytes()
        .all(|byte| byte == b'0')
        .then_some(Change::Replace { at, text })
}
