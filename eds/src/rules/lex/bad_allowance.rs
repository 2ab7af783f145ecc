use crate::{
    diagnostic::Level,
    document::Document,
    rules::{
        DocumentRule, LevelChange, Report,
        allowance::{Comment, comments},
        declare_rule,
    },
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds comments that start with `lexican:` and cannot be read, or that name a rule that does not exist.
    ///
    /// ## Why it matters
    /// Such a comment allows nothing. Above a line `; lexican: allow(CODE)` allows what the rule finds on that line, above a
    /// section's header what it finds in that section; `; lexican: allow-file(CODE)` anywhere allows what it finds in the
    /// file. Codes and letters of families are separated by commas; what follows the bracket is the reason, for people.
    ///
    /// ## Example
    /// ```ini
    /// ; lexican: allow(OBJ03) our tool cannot write hexadecimal numbers
    /// DefaultValue=-1
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// ; lexican: allow(OBJ003) our tool cannot write hexadecimal numbers
    /// DefaultValue=-1
    /// ```
    ///
    /// ## Reference
    /// docs/config.md
    pub(crate) BadAllowance { code: "LEX001", level: Level::Warn, since: "0.1.0" }
}

impl DocumentRule for BadAllowance {
    fn check(document: &Document, report: &mut Report) {
        for comment in comments(document.source()) {
            match comment {
                Comment::Unreadable(at) => {
                    report
                        .at(at, format!("comment {} cannot be read", report.quote(at)))
                        .help("write `; lexican: allow(CODE)` or `; lexican: allow-file(CODE)`");
                }
                Comment::Allow { names, .. } => names.into_iter().for_each(|name| unknown(name, report)),
            }
        }
    }
}

fn unknown(name: Span, report: &mut Report) {
    if let Err(error) = LevelChange::new(report.text(name), Level::Allow) {
        let (message, cure) = (
            error.to_string(),
            "name a code, such as OBJ003, or a family, such as OBJ",
        );
        report.at(name, message).help(cure);
    }
}
