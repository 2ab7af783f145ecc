//! Where lines start.

use crate::span::Span;

/// A place in a file as people count.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LineColumn {
    /// From 1.
    pub line: u32,
    /// From 1, in characters.
    pub column: u32,
}

/// The start of each line. LF, CR LF and a CR alone end a line.
#[derive(Clone, Debug, Default)]
pub(super) struct Lines {
    starts: Vec<u32>,
}

impl Lines {
    pub(super) fn of(text: &str) -> Self {
        Self {
            starts: split(text).map(|line| line.start).collect(),
        }
    }

    pub(super) fn count(&self) -> u32 {
        u32::try_from(self.starts.len()).unwrap_or(u32::MAX)
    }

    /// A line without its line end, counted from 1.
    pub(super) fn span(&self, text: &str, line: u32) -> Span {
        let Some(start) = line.checked_sub(1).and_then(|line| self.starts.get(line as usize)) else {
            return Span::default();
        };
        let end = self.starts.get(line as usize).map_or(text.len(), |end| *end as usize);
        let start = *start as usize;
        let content = text.get(start..end).unwrap_or_default().trim_end_matches(['\r', '\n']);
        Span::of(start..start + content.len())
    }

    pub(super) fn line_column(&self, text: &str, offset: u32) -> LineColumn {
        let line = self.starts.partition_point(|start| *start <= offset).max(1);
        let start = self.starts.get(line - 1).map_or(0, |start| *start as usize);
        let before = text.get(start..offset as usize).unwrap_or_default();
        LineColumn {
            line: u32::try_from(line).unwrap_or(u32::MAX),
            column: u32::try_from(before.chars().count() + 1).unwrap_or(u32::MAX),
        }
    }
}

/// The lines of `text`, each with its line end.
pub(super) fn split(text: &str) -> impl Iterator<Item = Span> {
    let bytes = text.as_bytes();
    let mut start = 0;
    std::iter::from_fn(move || {
        let rest = bytes.get(start..).filter(|rest| !rest.is_empty())?;
        let end = start + line_length(rest);
        let line = Span::of(start..end);
        start = end;
        Some(line)
    })
}

fn line_length(bytes: &[u8]) -> usize {
    match bytes.iter().position(|byte| matches!(byte, b'\n' | b'\r')) {
        Some(at) if bytes[at..].starts_with(b"\r\n") => at + 2,
        Some(at) => at + 1,
        None => bytes.len(),
    }
}
