//! Where a finding stands, as programs want it.

use lexican_eds::{source::Source, span::Span};
use serde::Serialize;

/// Lines and columns count from 1, columns in characters; `end_column` is that of the character behind the last.
#[derive(Clone, Copy, Serialize)]
pub(super) struct Place {
    pub(super) line: u32,
    pub(super) column: u32,
    pub(super) end_column: u32,
}

impl Place {
    pub(super) fn of(source: &Source, span: Span) -> Self {
        let start = source.line_column(span);
        let end = source.line_column(Span::new(span.end, span.end));
        Self {
            line: start.line,
            column: start.column,
            end_column: end.column,
        }
    }
}
