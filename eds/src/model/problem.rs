//! What a value or a keyword is, if not what it should be.

use crate::document::Keyword;
use crate::ir::DataType;
use crate::literal::{Fault, Note};
use crate::span::Span;

/// A fact about a keyword or its value that a reader stumbles over.
///
/// It says what is there, not how bad that is: the rules do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Problem {
    /// A value that cannot be read. The model goes on without it.
    Unreadable {
        /// The keyword.
        keyword: Keyword,
        /// What the keyword takes.
        expected: Expected,
        /// Why this is not it.
        fault: Fault,
        /// The value.
        at: Span,
    },
    /// A value that was read, but is written in an unusual way.
    Unusual {
        /// The keyword.
        keyword: Keyword,
        /// What the keyword takes.
        expected: Expected,
        /// What is unusual.
        note: Note,
        /// The value.
        at: Span,
    },
    /// `Keyword=` of a keyword that needs a value.
    EmptyValue {
        /// The keyword.
        keyword: Keyword,
        /// What the keyword takes.
        expected: Expected,
        /// The keyword as written.
        at: Span,
    },
    /// A keyword of CiA 306-1 in a section where it means nothing. It is passed over.
    MisplacedKeyword {
        /// The keyword.
        keyword: Keyword,
        /// The keyword as written.
        at: Span,
    },
    /// A keyword of EDS versions before 4. It is passed over.
    LegacyKeyword {
        /// The keyword.
        keyword: Keyword,
        /// The keyword as written.
        at: Span,
    },
    /// A value or limit in a section that has no data type. It cannot be read.
    ValueWithoutType {
        /// The keyword.
        keyword: Keyword,
        /// The value.
        at: Span,
    },
    /// A value or limit of a data type that CiA 301 does not define, or that is a structure. It cannot be read.
    ValueOfUnknownType {
        /// The keyword.
        keyword: Keyword,
        /// The type's index.
        data_type: u16,
        /// The value.
        at: Span,
    },
    /// A limit of a type that has no order: a text, bytes, a time. It is passed over.
    LimitOfUnorderedType {
        /// LowLimit or HighLimit.
        keyword: Keyword,
        /// The type.
        data_type: DataType,
        /// The limit.
        at: Span,
    },
}

/// What a keyword takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Expected {
    /// 0 or 1.
    Flag,
    /// 0 to 255.
    Unsigned8,
    /// 0 to 65535.
    Unsigned16,
    /// 0 to 4294967295.
    Unsigned32,
    /// A value of a data type.
    Value(DataType),
    /// The number of an object code: 0, 2, 5 to 9.
    ObjectCode,
    /// The index of a data type.
    DataType,
    /// `ro`, `rw`, `wo`, `rwr`, `rww`, `const`.
    AccessType,
    /// Any text.
    Text,
    /// Two indices: `0xA080-0xA0BF`.
    IndexRange,
    /// `n`, or `0;bits`.
    Count,
    /// `offset`, or `offset, difference`.
    PpOffset,
}

impl Problem {
    /// Where the problem stands.
    #[must_use]
    pub const fn span(&self) -> Span {
        match *self {
            Self::Unreadable { at, .. }
            | Self::Unusual { at, .. }
            | Self::EmptyValue { at, .. }
            | Self::MisplacedKeyword { at, .. }
            | Self::LegacyKeyword { at, .. }
            | Self::ValueWithoutType { at, .. }
            | Self::ValueOfUnknownType { at, .. }
            | Self::LimitOfUnorderedType { at, .. } => at,
        }
    }

    /// Whose value it is about.
    #[must_use]
    pub const fn keyword(&self) -> Keyword {
        match *self {
            Self::Unreadable { keyword, .. }
            | Self::Unusual { keyword, .. }
            | Self::EmptyValue { keyword, .. }
            | Self::MisplacedKeyword { keyword, .. }
            | Self::LegacyKeyword { keyword, .. }
            | Self::ValueWithoutType { keyword, .. }
            | Self::ValueOfUnknownType { keyword, .. }
            | Self::LimitOfUnorderedType { keyword, .. } => keyword,
        }
    }
}
