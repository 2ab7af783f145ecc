//! What a line is, seen alone.

use crate::span::Span;

/// What a line is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LineKind {
    /// Blank, or a comment after `;`.
    Nothing,
    /// A comment after `#`.
    HashComment,
    /// `[name]`, perhaps with a bracket missing or with more text behind.
    Header,
    /// `key=value`
    Pair,
    /// `=value`
    MissingKey,
    /// Anything else.
    Junk,
}

/// What `line` is, which is [trimmed](trim).
pub(super) fn classify(line: &str) -> LineKind {
    let bytes = line.as_bytes();
    match bytes.first() {
        None | Some(b';') => LineKind::Nothing,
        Some(b'#') => LineKind::HashComment,
        Some(b'[') => LineKind::Header,
        Some(b'=') => LineKind::MissingKey,
        Some(_) if bytes.contains(&b'=') => LineKind::Pair,
        Some(_) if is_header_without_opening(line) => LineKind::Header,
        Some(_) => LineKind::Junk,
    }
}

/// `1000]`
fn is_header_without_opening(line: &str) -> bool {
    line.ends_with(']') && !line.contains(['[', ' ', '\t'])
}

/// `line` without the blanks around it, among which NUL and Ctrl-Z count: programs of old fill up a file with them.
pub(crate) fn trim(line: &str) -> &str {
    let text = line.trim_end_matches(['\r', '\n']);
    match text.as_bytes() {
        [b'!'..=b'~'] | [b'!'..=b'~', .., b'!'..=b'~'] => text,
        _ => text.trim_matches(|character: char| character.is_whitespace() || matches!(character, '\0' | '\x1A')),
    }
}

/// The parts of a section's header. A bracket may be missing, more text may stand behind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Header {
    /// From bracket to bracket.
    pub(crate) brackets: Span,
    /// Between the brackets, without the blanks around.
    pub(crate) label: Span,
    /// Behind the brackets, without the blanks around.
    pub(crate) rest: Span,
    /// Whether both brackets are there.
    pub(crate) closed: bool,
}

impl Header {
    /// The parts of `line`, which is trimmed and starts at `start`.
    pub(crate) fn of(line: &str, start: u32) -> Self {
        let inner = line.strip_prefix('[').unwrap_or(line);
        let opening = line.len() - inner.len();
        let end = inner.find(']');
        let label = inner.get(..end.unwrap_or(inner.len())).unwrap_or_default();
        let header = opening + label.len() + usize::from(end.is_some());
        let rest = line.get(header..).unwrap_or_default();
        let part = |at: usize, text: &str| {
            let at = start as usize + at + text.len() - text.trim_start().len();
            Span::of(at..at + text.trim().len())
        };
        Self {
            brackets: Span::of(start as usize..start as usize + header),
            label: part(opening, label),
            rest: part(header, rest),
            closed: opening == 1 && end.is_some(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts(line: &str) -> (&str, &str, &str, bool) {
        let parts = Header::of(line, 0);
        let text = |span: Span| &line[span.range()];
        (text(parts.brackets), text(parts.label), text(parts.rest), parts.closed)
    }

    #[test]
    fn a_line_is_what_its_first_character_says() {
        for (line, kind) in [
            ("", LineKind::Nothing),
            ("; DataType=7", LineKind::Nothing),
            ("#DataType=7", LineKind::HashComment),
            ("[1000]", LineKind::Header),
            ("[1000", LineKind::Header),
            ("1000]", LineKind::Header),
            ("see [1000]", LineKind::Junk),
            ("DataType=7", LineKind::Pair),
            ("DataType=", LineKind::Pair),
            ("a[1]=7", LineKind::Pair),
            ("=7", LineKind::MissingKey),
            ("DataType 7", LineKind::Junk),
        ] {
            assert_eq!(classify(line), kind, "{line}");
        }
    }

    #[test]
    fn a_header_is_split_at_its_brackets() {
        assert_eq!(
            parts("[1003sub01] # repeat"),
            ("[1003sub01]", "1003sub01", "# repeat", true)
        );
        assert_eq!(parts("[ 1000\t]"), ("[ 1000\t]", "1000", "", true));
        assert_eq!(parts("[1000"), ("[1000", "1000", "", false));
        assert_eq!(parts("1000]"), ("1000]", "1000", "", false));
        assert_eq!(parts("[]"), ("[]", "", "", true));
        assert_eq!(parts("[a]b]"), ("[a]", "a", "b]", true));
    }

    #[test]
    fn blanks_and_what_programs_of_old_fill_up_with_are_trimmed() {
        assert_eq!(trim("DataType=7\r\n"), "DataType=7");
        assert_eq!(trim("\u{A0}DataType=7\t\n"), "DataType=7");
        assert_eq!(trim("\t DataType=7 \0\0\x1A"), "DataType=7");
        assert_eq!(trim("x"), "x");
        assert_eq!(trim("\x1A"), "");
    }
}
