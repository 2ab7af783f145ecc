use crate::{
    diagnostic::Level,
    document::{Document, Problem},
    fix::Fix,
    rules::{DocumentRule, Report, declare_rule},
    span::Span,
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
    pub(crate) ControlCharacter { code: "INI010", level: Level::Warn, since: "0.1.0", fixable: Sometimes }
}

impl DocumentRule for ControlCharacter {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::ControlCharacter { at, character } = *problem {
                report
                    .at(at, format!("control character {} in the text", name(character)))
                    .help("remove it")
                    .fix(is_end(document, at).then(|| Fix::replace(rest_of_line(document, at), "")));
            }
        }
    }
}

/// Whether the file ends here: nothing but what programs of old fill up with follows. Those that end at Ctrl-Z and those that
/// pass over it read the same file.
fn is_end(document: &Document, at: Span) -> bool {
    let rest = document.source().text().get(at.start as usize..).unwrap_or_default();
    rest.chars().all(is_filling)
}

/// From `at` to the end of its line, the line end left out.
fn rest_of_line(document: &Document, at: Span) -> Span {
    let rest = document.source().text().get(at.start as usize..).unwrap_or_default();
    let length = rest.find(['\r', '\n']).unwrap_or(rest.len());
    Span::of(at.start as usize..at.start as usize + length)
}

const fn is_filling(character: char) -> bool {
    matches!(character, '\0' | '\x1A') || character.is_ascii_whitespace()
}

fn name(character: char) -> String {
    match character {
        '\0' => "NUL".to_owned(),
        '\x1A' => "Ctrl-Z".to_owned(),
        other => format!("{:02X}h", u32::from(other)),
    }
}
