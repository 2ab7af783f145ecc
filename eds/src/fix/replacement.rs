//! A cure as text in place of text, for programs that make it themselves.

use super::{Change, Fix, plan::Plan};
use crate::{
    document::{Document, Edit},
    span::Span,
};

/// New text in place of old.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Replacement {
    /// The old text: empty where lines are added, over the line end where they go.
    pub at: Span,
    /// The new text, with the line ends of the file.
    pub text: String,
}

impl Fix {
    /// What this fix, made alone, changes in `document`, in the order of the file.
    ///
    /// None for the whole file's line ends or byte order mark, and none where an object is put into a list or taken out: every
    /// such fix numbers the rest of the list anew, so that they cannot be made one after the other.
    #[must_use]
    pub fn replacements(&self, document: &Document) -> Vec<Replacement> {
        let stands_alone = |change: &Change| {
            !matches!(
                change,
                Change::Enlist { .. } | Change::Strike { .. } | Change::LineEnds | Change::ByteOrderMark
            )
        };
        if !self.changes.iter().all(stands_alone) {
            return Vec::new();
        }
        let edit = Plan::of(document, std::iter::once(self));
        edit.map(Edit::replacements).unwrap_or_default()
    }
}
