//! Lines in another order.

use super::{EditError, apply::Written};
use crate::document::Document;

/// A line of a new document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct ArrangedLine {
    /// The line of the old document that it was, from 1; 0 for a new one. Its encoding stays.
    pub(crate) was: u32,
    /// What it says now, without a line end.
    pub(crate) text: String,
}

impl Document {
    /// A document of these lines, each ended as the first line of this one is.
    ///
    /// # Errors
    /// When a line would not read back as it is.
    pub(crate) fn arranged(&self, lines: &[ArrangedLine]) -> Result<Self, EditError> {
        let source = self.source();
        let end = match source.line_end(1).text() {
            "" => "\n",
            end => end,
        };
        let mut written = Written::new(source, source.byte_order_mark());
        for line in lines {
            let new = format!("{}{end}", line.text);
            written.line(line.was, source.line_text(line.was), &new)?;
        }
        written.read_back().map(Self::read)
    }
}
