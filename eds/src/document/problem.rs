//! What a reader of lines stumbles over.

use crate::source::{Encoding, Format};
use crate::span::Span;

/// A fact about lines, sections and bytes that CiA 306-1 does not allow, or that makes a reader guess.
///
/// It says what is there, not how bad that is: the rules do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Problem {
    /// The file is something else. The document has no sections, and no other problem.
    NotCanopen {
        /// What it is.
        what: Format,
        /// What gave it away.
        at: Span,
    },
    /// The file starts with the UTF-8 byte order mark.
    ByteOrderMark {
        /// The first line, where editors show it.
        at: Span,
    },
    /// A line with characters beyond ASCII. One problem a line.
    NotAscii {
        /// The first such character.
        at: Span,
        /// What the line was read as.
        encoding: Encoding,
    },
    /// A control character, neither tab nor line end: NUL, or Ctrl-Z as the end of file of old. One problem a line.
    ControlCharacter {
        /// The first of them.
        at: Span,
        /// Which: NUL is `'\0'`, Ctrl-Z is `'\x1A'`.
        character: char,
    },
    /// Line ends are not all the same.
    MixedLineEnds {
        /// The first line whose end differs from the line before.
        at: Span,
    },
    /// A line with neither `=` nor brackets nor `;` before it. It is passed over.
    JunkLine {
        /// The line.
        at: Span,
    },
    /// `=value` without a keyword. It is passed over.
    MissingKeyword {
        /// The line.
        at: Span,
    },
    /// A line that starts with `#`, which is no comment in an EDS; it is passed over like one.
    HashComment {
        /// The line.
        at: Span,
    },
    /// A keyword and its value take more than 255 characters.
    OverlongLine {
        /// From the keyword to the end of the value.
        at: Span,
        /// How many characters.
        characters: u32,
    },
    /// A keyword and its value before the first section. It is passed over.
    KeywordOutsideSection {
        /// The keyword.
        at: Span,
    },
    /// `[name` without `]`. What follows belongs to no section.
    MalformedHeader {
        /// The line.
        at: Span,
    },
    /// A section's header that does not start in column 1.
    IndentedHeader {
        /// The header.
        at: Span,
    },
    /// Text after a section's header.
    TextAfterHeader {
        /// The text.
        at: Span,
    },
    /// A section of a name that was there before. CiA 306-1, 4.3: a name is used once.
    DuplicateSection {
        /// The label of the second one.
        at: Span,
        /// The label of the first one.
        first: Span,
    },
    /// A keyword that was there before in the same section.
    DuplicateKeyword {
        /// The second one.
        at: Span,
        /// The first one.
        first: Span,
    },
    /// A section that CiA 306-1 does not know.
    UnknownSection {
        /// Its label.
        at: Span,
    },
    /// A section whose name is understood, but not written as the standard writes it: `[0x1000]`, `[1018sub01]`, `[ 1000]`.
    BadSectionName {
        /// Its label.
        at: Span,
    },
    /// A keyword that CiA 306-1 does not know.
    UnknownKeyword {
        /// The keyword.
        at: Span,
    },
}

impl Problem {
    /// Where the problem stands.
    #[must_use]
    pub const fn span(&self) -> Span {
        match *self {
            Self::NotCanopen { at, .. }
            | Self::ByteOrderMark { at }
            | Self::NotAscii { at, .. }
            | Self::ControlCharacter { at, .. }
            | Self::MixedLineEnds { at }
            | Self::JunkLine { at }
            | Self::MissingKeyword { at }
            | Self::HashComment { at }
            | Self::OverlongLine { at, .. }
            | Self::KeywordOutsideSection { at }
            | Self::MalformedHeader { at }
            | Self::IndentedHeader { at }
            | Self::TextAfterHeader { at }
            | Self::DuplicateSection { at, .. }
            | Self::DuplicateKeyword { at, .. }
            | Self::UnknownSection { at }
            | Self::BadSectionName { at }
            | Self::UnknownKeyword { at } => at,
        }
    }
}
