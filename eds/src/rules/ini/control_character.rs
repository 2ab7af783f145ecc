use crate::{
    diagnostic::Level,
    document::{Document, Problem},
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds control characters other than tab and line end, such as NUL, or the Ctrl-Z that ended a file in the days of DOS.
    /// One finding a line, at the first of them.
    ///
    /// ## Why it matters
    /// C programs end a text at NUL, old ones end the file at Ctrl-Z, others take the character for a part of the value.
    ///
    /// ## Example
    /// A file that ends in `0x1A`, as old editors wrote it.
    ///
    /// ## Reference
    /// CiA 306-1, format of the file: ASCII
    pub(crate) ControlCharacter { code: "INI010", level: Level::Warn, since: "0.1.0" }
}

impl DocumentRule for ControlCharacter {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::ControlCharacter { at, character } = *problem {
                report
                    .at(at, format!("control character {} in the text", name(character)))
                    .help("remove it");
            }
        }
    }
}

fn name(character: char) -> String {
    match character {
        '\0' => "NUL".to_owned(),
        '\x1A' => "Ctrl-Z".to_owned(),
        other => format!("{:02X}h", u32::from(other)),
    }
}
