use crate::{
    diagnostic::Level,
    fix::Fix,
    ir::{DataType, ObjectCode},
    literal::Note,
    model::{Eds, Expected},
    rules::{ModelRule, Report, Unusual, declare_rule, unusual},
};

declare_rule! {
    /// ## What it does
    /// Finds an ObjectType or DataType that is the name of the type in place of its number.
    ///
    /// ## Why it matters
    /// The standard knows numbers alone, and so do most readers.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// ObjectType=VAR
    /// DataType=UNSIGNED16
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// ObjectType=0x7
    /// DataType=0x0006
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, ObjectType and DataType; CiA 301, object codes and data types
    pub(crate) NamedNumber { code: "OBJ023", level: Level::Warn, since: "0.1.0", fixable: Always }
}

impl ModelRule for NamedNumber {
    fn check(eds: &Eds, report: &mut Report) {
        for Unusual { keyword, expected, at } in unusual(eds, Note::Name) {
            let (value, bare) = (report.quote(at), report.bare(at));
            let number = number(report.text(bare), expected);
            let cure = number.as_ref().map(|number| format!("write `{number}`"));
            report
                .at(at, format!("{keyword} {value} is a name, where a number belongs"))
                .help(cure.unwrap_or_else(|| "write its number".into()))
                .fix(number.map(|number| Fix::replace(bare, number)));
        }
    }
}

fn number(name: &str, expected: Expected) -> Option<String> {
    match expected {
        Expected::ObjectCode => ObjectCode::from_name(name).map(|code| format!("0x{:X}", code.number())),
        _ => DataType::from_name(name).map(|data_type| format!("0x{:04X}", data_type.index())),
    }
}
