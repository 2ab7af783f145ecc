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

/// What ends a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LineEnd {
    /// LF, as Unix writes.
    Lf,
    /// CR LF, as Windows writes.
    CrLf,
    /// CR alone, as a Mac of old wrote.
    Cr,
    /// The end of the file.
    None,
}

impl LineEnd {
    /// The characters.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::Lf => "\n",
            Self::CrLf => "\r\n",
            Self::Cr => "\r",
            Self::None => "",
        }
    }

    /// What ends `line`.
    pub(crate) fn of(line: &str) -> Self {
        match line.as_bytes() {
            [.., b'\r', b'\n'] => Self::CrLf,
            [.., b'\n'] => Self::Lf,
            [.., b'\r'] => Self::Cr,
            _ => Self::None,
        }
    }
}

/// The start of each line.
#[derive(Clone, Debug, Default)]
pub(super) struct Lines {
    starts: Vec<u32>,
}

impl Lines {
    pub(super) fn of(text: &str) -> Self {
        let mut starts = Vec::with_capacity(text.len() / 16);
        starts.extend(split(text.as_bytes()).map(|line| line.start));
        Self { starts }
    }

    pub(super) fn count(&self) -> u32 {
        u32::try_from(self.starts.len()).unwrap_or(u32::MAX)
    }

    /// A line, counted from 1, with its line end; empty when there is no such line.
    pub(super) fn span(&self, text: &str, line: u32) -> Span {
        let start_of = |line: u32| self.starts.get(line as usize).copied();
        let Some(start) = line.checked_sub(1).and_then(start_of) else {
            return Span::default();
        };
        match start_of(line) {
            Some(end) => Span::new(start, end),
            None => Span::of(start as usize..text.len()),
        }
    }

    /// The lines, each with its line end.
    pub(super) fn spans(&self, text: &str) -> impl Iterator<Item = Span> {
        let end = Span::of(0..text.len()).end;
        let ends = self.starts.iter().skip(1).copied().chain([end]);
        self.starts.iter().zip(ends).map(|(start, end)| Span::new(*start, end))
    }

    pub(super) fn line_column(&self, text: &str, offset: u32) -> LineColumn {
        let line = self.starts.partition_point(|start| *start <= offset).max(1);
        let start = self.starts.get(line - 1).map_or(0, |start| *start as usize);
        let before = text.get(start..offset as usize).unwrap_or_default();
        let count = |count| u32::try_from(count).unwrap_or(u32::MAX);
        LineColumn {
            line: count(line),
            column: count(before.chars().count() + 1),
        }
    }
}

/// The lines of a text in any encoding that has ASCII in it, each with its line end: LF, CR LF or CR alone.
pub(super) fn split(text: &[u8]) -> impl Iterator<Item = Span> {
    let mut start = 0;
    std::iter::from_fn(move || {
        let rest = text.get(start..).filter(|rest| !rest.is_empty())?;
        let line = Span::of(start..start + line_length(rest));
        start = line.end as usize;
        Some(line)
    })
}

fn line_length(text: &[u8]) -> usize {
    let end = text.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
    end.map_or(text.len(), |end| match text.get(end..) {
        Some([b'\r', b'\n', ..]) => end + 2,
        _ => end + 1,
    })
}
