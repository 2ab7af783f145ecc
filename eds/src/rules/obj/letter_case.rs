use super::words::more;
use crate::{
    diagnostic::Level,
    literal::Note,
    model::Eds,
    rules::{ModelRule, Report, Unusual, declare_rule, unusual},
};

declare_rule! {
    /// ## What it does
    /// Finds an AccessType in capital letters. One finding a file, at the first of them.
    ///
    /// ## Why it matters
    /// The standard has it in small letters, and a reader that compares letter by letter does not know the word.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// AccessType=RW
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// AccessType=rw
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, AccessType
    pub(crate) LetterCase { code: "OBJ013", level: Level::Note, since: "0.1.0" }
}

impl ModelRule for LetterCase {
    fn check(eds: &Eds, report: &mut Report) {
        let mut found = unusual(eds, Note::LetterCase);
        if let Some(Unusual { keyword, at, .. }) = found.next() {
            let cure = format!("write `{}`", report.text(at).to_ascii_lowercase());
            let (value, more) = (report.quote(at), more(found.count()));
            report
                .at(at, format!("{keyword} {value} is not in small letters{more}"))
                .help(cure);
        }
    }
}
