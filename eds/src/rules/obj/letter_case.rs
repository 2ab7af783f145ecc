use crate::{
    diagnostic::Level,
    fix::{Change, Fix},
    literal::Note,
    model::Eds,
    rules::{ModelRule, Report, Unusual, declare_rule, more, unusual},
    span::Span,
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
    pub(crate) LetterCase { code: "OBJ013", level: Level::Note, since: "0.1.0", fixable: Always }
}

impl ModelRule for LetterCase {
    fn check(eds: &Eds, report: &mut Report) {
        let found = unusual(eds, Note::LetterCase);
        if let Some(Unusual { keyword, at, .. }) = found.clone().next() {
            let cure = format!("write `{}`", report.text(report.bare(at)).to_ascii_lowercase());
            let fix: Fix = found.clone().map(|Unusual { at, .. }| lower(report, at)).collect();
            let (value, more) = (report.quote(at), more(found.count() - 1));
            report
                .at(at, format!("{keyword} {value} is not in small letters{more}"))
                .help(cure)
                .fix(fix);
        }
    }
}

fn lower(report: &Report, at: Span) -> Change {
    let at = report.bare(at);
    Change::Replace {
        at,
        text: report.text(at).to_ascii_lowercase(),
    }
}
