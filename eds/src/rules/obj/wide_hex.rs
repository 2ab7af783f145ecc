use super::words::{more, unusual};
use crate::{
    diagnostic::Level,
    literal::Note,
    model::Eds,
    rules::{ModelRule, Report, declare_rule},
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
        if let Some((keyword, at)) = found.next() {
            let (value, more) = (report.quote(at), more(found.count()));
            report
                .at(at, format!("{keyword} {value} has more digits than its type{more}"))
                .help("leave out leading zeros");
        }
    }
}
