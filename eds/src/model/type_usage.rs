//! `[DummyUsage]` (CiA 306-1, 4.4.3) and `[StandardDataTypes]`.

use super::field::Fields;
use crate::document::{Keyword, Section};
use crate::span::{Span, Spanned};

/// A section that says of data types whether they are used.
#[derive(Clone, Debug, Default)]
pub struct TypeUsage {
    /// The section's header.
    pub header: Span,
    /// In the order of the file.
    pub types: Vec<UsedType>,
}

/// `Dummy0005=1`
#[derive(Clone, Copy, Debug)]
pub struct UsedType {
    /// The type's index in the dictionary.
    pub data_type: u16,
    /// The keyword.
    pub key: Span,
    /// Whether it is used.
    pub used: Spanned<bool>,
}

pub(super) fn read(fields: &mut Fields<'_>, section: &Section) -> TypeUsage {
    let mut types = Vec::new();
    for entry in &section.entries {
        match entry.keyword {
            Keyword::Dummy(data_type) | Keyword::DataTypeIndex(data_type) => {
                types.extend(fields.flag(entry).map(|used| UsedType {
                    data_type,
                    key: entry.key,
                    used,
                }));
            }
            _ => fields.misplaced(entry),
        }
    }
    TypeUsage {
        header: section.header,
        types,
    }
}
