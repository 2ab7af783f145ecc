//! One comment to Lexican, read.

use std::iter;

use crate::{source::Source, span::Span};

/// What makes a comment one to us.
const MARK: &str = "lexican:";

/// A comment that begins with `lexican:`.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Comment {
    /// `allow(OBJ003, INI)`, `allow-file(OBJ003)`
    Allow {
        /// The comment's line, counted from 1.
        line: u32,
        reach: Reach,
        /// The codes and families as written.
        names: Vec<Span>,
    },
    /// Anything else.
    Unreadable(Span),
}

/// What an allowance is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reach {
    /// The line below, or the section that it begins.
    Below,
    /// The file.
    File,
}

/// The comments of `source` to Lexican, in order.
pub(crate) fn comments(source: &Source) -> impl Iterator<Item = Comment> {
    marked_lines(source).filter_map(|(number, line, mark)| {
        let text = source.slice(line);
        let before = text.get(..mark)?;
        let is_comment = before.trim_start().starts_with(';') && before.trim_matches([' ', '\t', ';']).is_empty();
        let start = mark + MARK.len();
        let instruction = text.get(start..)?;
        is_comment.then(|| read(instruction, line.start as usize + start, number))
    })
}

/// The lines with a mark in them: number, place, and where in the line the first mark is. What follows in a line is passed over:
/// it is no comment of its own, and there may be millions.
fn marked_lines(source: &Source) -> impl Iterator<Item = (u32, Span, usize)> {
    let mut from = 0;
    iter::from_fn(move || {
        let at = from + source.text().get(from..)?.find(MARK)?;
        let number = source.line_column(Span::of(at..at)).line;
        let line = source.line_span(number);
        from = (line.end as usize).max(at + MARK.len());
        Some((number, line, at - line.start as usize))
    })
}

/// Reads what stands behind the mark, from `start` on.
fn read(instruction: &str, start: usize, line: u32) -> Comment {
    match allowance(instruction, start) {
        Some((reach, names)) => Comment::Allow { line, reach, names },
        None => Comment::Unreadable(Span::of(start - MARK.len()..start + instruction.trim_end().len())),
    }
}

/// `allow(OBJ003, INI) and whatever follows`
fn allowance(instruction: &str, start: usize) -> Option<(Reach, Vec<Span>)> {
    let rest = instruction.trim_start().strip_prefix("allow")?;
    let (reach, rest) = match rest.strip_prefix("-file") {
        Some(rest) => (Reach::File, rest),
        None => (Reach::Below, rest),
    };
    let (names, _) = rest.trim_start().strip_prefix('(')?.split_once(')')?;
    let offset = |part: &str| start + (part.as_ptr().addr() - instruction.as_ptr().addr());
    let names = names.split(',').map(str::trim);
    let names: Vec<Span> = names
        .map(|name| Span::of(offset(name)..offset(name) + name.len()))
        .collect();
    let whole = names.iter().all(|name| !name.is_empty());
    whole.then_some((reach, names))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read_all(text: &str) -> Vec<String> {
        let source = Source::decode("x.eds", text.into());
        let comments = comments(&source).map(|comment| match comment {
            Comment::Allow { line, reach, names } => {
                let names: Vec<&str> = names.iter().map(|name| source.slice(*name)).collect();
                format!("{line} {reach:?} {}", names.join(" "))
            }
            Comment::Unreadable(at) => format!("? {}", source.slice(at)),
        });
        comments.collect()
    }

    #[test]
    fn an_allowance_names_codes_and_may_give_a_reason() {
        assert_eq!(read_all("; lexican: allow(OBJ003)\n"), ["1 Below OBJ003"]);
        assert_eq!(
            read_all("\n  ;;lexican:allow ( OBJ003 , ini ): the tool of old\r\n"),
            ["2 Below OBJ003 ini"]
        );
        assert_eq!(read_all("; lexican: allow-file(INI)"), ["1 File INI"]);
    }

    #[test]
    fn what_is_no_allowance_is_told() {
        assert_eq!(read_all("; lexican: alow(OBJ003) \n"), ["? lexican: alow(OBJ003)"]);
        assert_eq!(read_all("; lexican: allow OBJ003\n"), ["? lexican: allow OBJ003"]);
        assert_eq!(read_all("; lexican: allow(OBJ003,)\n"), ["? lexican: allow(OBJ003,)"]);
        assert_eq!(read_all("; lexican: allow()\n"), ["? lexican: allow()"]);
        assert_eq!(read_all("; lexican:"), ["? lexican:"]);
    }

    #[test]
    fn text_that_is_no_comment_speaks_to_nobody() {
        assert_eq!(read_all("ParameterName=; lexican: allow(OBJ003)\n"), [""; 0]);
        assert_eq!(read_all("lexican: allow(OBJ003)\n"), [""; 0]);
        assert_eq!(read_all("; made by lexican: allow(OBJ003)\n"), [""; 0]);
        assert_eq!(read_all("# lexican: allow(OBJ003)\n"), [""; 0]);
    }
}
