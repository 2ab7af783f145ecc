//! Safe cures: what a rule's finding offers to change in the file, and how that is done.
//!
//! A rule states its cure beside its check, as a [`Fix`] of the diagnostic. A cure is safe when
//!
//! - there is only one: somebody who knows the device would write the same;
//! - the device that the file describes stays the same, but for the very fact that the finding is about;
//! - nothing is lost: a comment that is in the way moves.
//!
//! [`mend`] makes all of them, on the lines that they name. Every other byte of the file stays.

mod lists;
mod mend;
mod plan;
mod replacement;

pub use mend::{Mended, mend};
pub use replacement::Replacement;

use crate::{
    document::{Keyword, SectionName},
    ir::ObjectList,
    span::Span,
};

/// The cure of one finding. Its changes are made together or not at all.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    pub(crate) changes: Vec<Change>,
}

/// A change to a document, in places of the document as it was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Change {
    /// New text in place of what stands at `at`, within its line.
    Replace { at: Span, text: String },
    /// A comment on a line of its own, above the line that `at` is on.
    Comment { at: Span, text: String },
    /// A keyword in the section with this header, where the standard's order has it.
    Keyword {
        header: Span,
        keyword: Keyword,
        value: String,
    },
    /// A section, where the standard's order has it.
    Section {
        name: SectionName,
        entries: Vec<(Keyword, String)>,
    },
    /// An object in its list. Lists are numbered and counted anew whenever they change.
    Enlist { list: ObjectList, index: u16 },
    /// The line of a list whose value stands at `at` goes.
    Strike { at: Span },
    /// The list is numbered and counted anew.
    Number { list: ObjectList },
    /// All lines end as most of them do.
    LineEnds,
    /// The byte order mark goes.
    ByteOrderMark,
}

impl Fix {
    /// One change.
    pub(crate) fn new(change: Change) -> Self {
        Self { changes: vec![change] }
    }

    /// `text` in place of what stands at `at`.
    pub(crate) fn replace(at: Span, text: impl Into<String>) -> Self {
        Self::new(Change::Replace { at, text: text.into() })
    }

    /// One more change, to be made together with the others.
    pub(crate) fn and(mut self, change: Change) -> Self {
        self.changes.push(change);
        self
    }
}

impl FromIterator<Change> for Fix {
    fn from_iter<I: IntoIterator<Item = Change>>(changes: I) -> Self {
        Self {
            changes: changes.into_iter().collect(),
        }
    }
}
