//! Lines to headers and pairs, with their positions.
//!
//! rust-ini reads the pairs. It knows no positions and stumbles over much that real files hold: a byte order mark, a line
//! without `=`, a comment that is indented or stands behind a header, a backslash at the end of a line. So each line is
//! [classified](classify) first; rust-ini is given the pairs alone, [repaired](pairs) where it would misread them, and
//! what it reads is put together with the lines' positions. Most lines of an EDS occur many times (`ObjectType=0x7`);
//! rust-ini reads each of them once.

mod classify;
mod pairs;

pub(crate) use classify::{Header, trim};

use crate::source::Source;
use crate::span::Span;
use classify::{LineKind, classify};
use pairs::Pairs;

/// A line that is neither blank nor a comment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Line {
    /// The header of a section; [`Header::of`] takes it apart.
    Header {
        line: Span,
        /// How many pairs stand between it and the next header.
        pairs: usize,
    },
    /// A key and its value without the blanks around them.
    Pair { key: Span, value: Span },
    /// `=value`
    MissingKey(Span),
    /// A line that starts with `#`.
    HashComment(Span),
    /// A line that is nothing of that.
    Junk(Span),
}

/// Reads the lines of `source`, in order.
pub(crate) fn read(source: &Source) -> impl Iterator<Item = Line> {
    let mut pairs = Pairs::new(source.text());
    let mut pairs_below = Vec::new();
    let mut lines = Vec::with_capacity(source.line_count() as usize);
    for whole in source.lines() {
        let line = source.slice(whole);
        let text = trim(line);
        let start = whole.start as usize + leading(line, text);
        let span = Span::of(start..start + text.len());
        let kind = classify(text);
        match kind {
            LineKind::Nothing => continue,
            LineKind::Header => pairs_below.push(0),
            LineKind::Pair => {
                pairs.add(span);
                pairs_below.last_mut().into_iter().for_each(|count| *count += 1);
            }
            _ => {}
        }
        lines.push((kind, span));
    }
    let mut pairs = pairs.read();
    let mut pairs_below = pairs_below.into_iter();
    lines.into_iter().map(move |(kind, line)| match kind {
        LineKind::Header => Line::Header {
            line,
            pairs: pairs_below.next().unwrap_or(0),
        },
        LineKind::Pair => pairs
            .next()
            .map_or(Line::Junk(line), |(key, value)| Line::Pair { key, value }),
        LineKind::MissingKey => Line::MissingKey(line),
        LineKind::HashComment => Line::HashComment(line),
        LineKind::Nothing | LineKind::Junk => Line::Junk(line),
    })
}

/// How many bytes of `line` stand before `text`, which is `line` trimmed.
fn leading(line: &str, text: &str) -> usize {
    if line.as_bytes().first() == text.as_bytes().first() {
        0
    } else {
        line.find(text).unwrap_or(0)
    }
}
