//! What does not fit together.

use crate::document::Keyword;
use crate::ir::{Address, ObjectCode, ObjectList};
use crate::span::Span;

/// A fact about objects that CiA 306-1 does not allow, or that makes the reader guess.
///
/// It says what is there, not how bad that is: the rules do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Problem {
    /// A value's description lacks a keyword that it must have. [Lowering](super) has a table of what takes its place.
    MissingKeyword {
        /// ParameterName, DataType or AccessType.
        keyword: Keyword,
        /// The value.
        address: Address,
        /// The header of its section.
        at: Span,
    },
    /// A data type that CiA 301 does not define, or a structure, of a single value. It is taken for a DOMAIN.
    UnknownDataType {
        /// The value.
        address: Address,
        /// The type's index.
        data_type: u16,
        /// The type.
        at: Span,
    },
    /// The sections of an object are those of another object code than its ObjectType, or it has no ObjectType and is not
    /// a VAR.
    AssumedObjectCode {
        /// The object.
        index: u16,
        /// What it is taken for.
        assumed: ObjectCode,
        /// ObjectType; without it, the header of the object's section.
        at: Span,
    },
    /// Sub-objects of an object that cannot have any. They are left out.
    SubsOfSingleValue {
        /// The object.
        index: u16,
        /// Its object code.
        code: ObjectCode,
        /// The header of its first sub-object.
        at: Span,
    },
    /// An ARRAY or RECORD without a single sub-object.
    NoSubs {
        /// The object.
        index: u16,
        /// The header of its section.
        at: Span,
    },
    /// An ARRAY or RECORD without sub-index 0. It gets one.
    MissingSubZero {
        /// The object.
        index: u16,
        /// What its sub-index 0 says now: the highest sub-index.
        highest: u8,
        /// The header of its section.
        at: Span,
    },
    /// Sections of an object that has no section itself. It is taken for a RECORD if it has sub-objects, else left out.
    OrphanedSubs {
        /// The object.
        index: u16,
        /// The header of the first of them.
        at: Span,
    },
    /// CompactSubObj beyond 254. It is taken for 254.
    TooManySubs {
        /// The object.
        index: u16,
        /// CompactSubObj.
        at: Span,
    },
    /// The file's compact forms and modules stand for more than 500,000 values. Those of this object are left out.
    TooManyValues {
        /// The object.
        index: u16,
        /// CompactSubObj, or the header of the module's extension.
        at: Span,
    },
    /// A line of `[xxxxName]`, `[xxxxValue]` or `[xxxxDenotation]` for a sub-object that is not there. It is passed over.
    LineOfNoSub {
        /// The object.
        index: u16,
        /// The line's number.
        number: u32,
        /// The number as written.
        at: Span,
    },
    /// An object list names an object that has no section.
    AbsentObject {
        /// The object.
        index: u16,
        /// The list.
        list: ObjectList,
        /// The index in the list.
        at: Span,
    },
    /// An object that no list names. It is in the dictionary all the same.
    UnlistedObject {
        /// The object.
        index: u16,
        /// The header of its section.
        at: Span,
    },
    /// An object that the lists name twice. The first list counts.
    ListedTwice {
        /// The object.
        index: u16,
        /// The index as listed again.
        at: Span,
        /// The index as listed first.
        first: Span,
    },
    /// A connected module that the file does not describe.
    UnknownModule {
        /// The module's number.
        number: u16,
        /// The number in `[ConnectedModules]`.
        at: Span,
    },
    /// A module needs an object that the file does not describe.
    AbsentModuleObject {
        /// The module's number.
        number: u16,
        /// The object.
        index: u16,
        /// The index in the module's list.
        at: Span,
    },
    /// More connected modules than object 1027h can list, 254. The others are passed over.
    TooManyModules {
        /// The first of the others in `[ConnectedModules]`.
        at: Span,
    },
    /// The connected modules add more sub-objects to an object than it can have. The others are left out.
    NoRoomForModule {
        /// The object that is full.
        index: u16,
        /// The header of the module's extension.
        at: Span,
    },
}

impl Problem {
    /// Where the problem stands.
    #[must_use]
    pub const fn span(&self) -> Span {
        match *self {
            Self::MissingKeyword { at, .. }
            | Self::UnknownDataType { at, .. }
            | Self::AssumedObjectCode { at, .. }
            | Self::SubsOfSingleValue { at, .. }
            | Self::NoSubs { at, .. }
            | Self::MissingSubZero { at, .. }
            | Self::OrphanedSubs { at, .. }
            | Self::TooManySubs { at, .. }
            | Self::TooManyValues { at, .. }
            | Self::LineOfNoSub { at, .. }
            | Self::AbsentObject { at, .. }
            | Self::UnlistedObject { at, .. }
            | Self::ListedTwice { at, .. }
            | Self::UnknownModule { at, .. }
            | Self::AbsentModuleObject { at, .. }
            | Self::TooManyModules { at }
            | Self::NoRoomForModule { at, .. } => at,
        }
    }
}
