//! Reads the value of one entry by the kind that its keyword takes.

use super::{Expected, Problem};
use crate::document::{Document, Entry};
use crate::ir::{AccessType, DataType, ObjectCode, Value};
use crate::literal::{self, Fault, Literal, Note, Notes};
use crate::span::{Span, Spanned};

/// Reads entries of a document and keeps what it stumbles over.
pub(super) struct Fields<'d> {
    pub(super) document: &'d Document,
    pub(super) problems: Vec<Problem>,
}

/// A number that a keyword takes.
pub(super) trait Unsigned: TryFrom<u64> {
    const EXPECTED: Expected;
    const MAX: u64;
}

impl Unsigned for u8 {
    const EXPECTED: Expected = Expected::Unsigned8;
    const MAX: u64 = 0xFF;
}

impl Unsigned for u16 {
    const EXPECTED: Expected = Expected::Unsigned16;
    const MAX: u64 = 0xFFFF;
}

impl Unsigned for u32 {
    const EXPECTED: Expected = Expected::Unsigned32;
    const MAX: u64 = 0xFFFF_FFFF;
}

/// Keeps the first value of a keyword.
pub(super) fn first<T>(field: &mut Option<T>, value: Option<T>) {
    if field.is_none() {
        *field = value;
    }
}

impl<'d> Fields<'d> {
    pub(super) fn slice(&self, span: Span) -> &'d str {
        self.document.text(span)
    }

    /// A text; an empty one is a value, too.
    #[expect(clippy::unnecessary_wraps, reason = "fills a field as the others do")]
    pub(super) fn text(&mut self, entry: &Entry) -> Option<Spanned<String>> {
        let Literal { value, notes } = literal::text(self.slice(entry.value));
        self.note(entry, Expected::Text, notes);
        Some(Spanned::new(value.to_owned(), entry.value))
    }

    pub(super) fn number<T: Unsigned>(&mut self, entry: &Entry) -> Option<Spanned<T>> {
        self.read(entry, T::EXPECTED, |text| {
            let literal = literal::unsigned(text, T::MAX)?;
            let value = T::try_from(literal.value).map_err(|_| Fault::OutOfRange)?;
            Ok(literal.map(|_| value))
        })
    }

    pub(super) fn flag(&mut self, entry: &Entry) -> Option<Spanned<bool>> {
        self.read(entry, Expected::Flag, |text| {
            literal::unsigned(text, 1).map(|literal| literal.map(|value| value != 0))
        })
    }

    pub(super) fn access(&mut self, entry: &Entry) -> Option<Spanned<AccessType>> {
        self.read(entry, Expected::AccessType, literal::access)
    }

    pub(super) fn object_code(&mut self, entry: &Entry) -> Option<Spanned<ObjectCode>> {
        self.read(entry, Expected::ObjectCode, literal::object_code)
    }

    pub(super) fn data_type(&mut self, entry: &Entry) -> Option<Spanned<u16>> {
        self.read(entry, Expected::DataType, literal::data_type)
    }

    /// A value of the type with index `data_type`; an empty one is none.
    pub(super) fn value(&mut self, entry: &Entry, data_type: Option<u16>) -> Option<Spanned<Value>> {
        if entry.value.is_empty() {
            return None;
        }
        let (keyword, at) = (entry.keyword, entry.value);
        let Some(index) = data_type else {
            self.problems.push(Problem::ValueWithoutType { keyword, at });
            return None;
        };
        let Some(data_type) = DataType::from_index(index) else {
            self.problems.push(Problem::ValueOfUnknownType {
                keyword,
                data_type: index,
                at,
            });
            return None;
        };
        self.read(entry, Expected::Value(data_type), |text| {
            literal::value(text, data_type)
        })
    }

    /// A limit: a value of a type that has an order.
    pub(super) fn limit(&mut self, entry: &Entry, data_type: Option<u16>) -> Option<Spanned<Value>> {
        let unordered = data_type
            .and_then(DataType::from_index)
            .filter(|data_type| !data_type.is_ordered());
        let Some(data_type) = unordered.filter(|_| !entry.value.is_empty()) else {
            return self.value(entry, data_type);
        };
        self.problems.push(Problem::LimitOfUnorderedType {
            keyword: entry.keyword,
            data_type,
            at: entry.value,
        });
        None
    }

    pub(super) fn misplaced(&mut self, entry: &Entry) {
        // What the standard does not know is the document's problem.
        if entry.keyword != crate::document::Keyword::Unknown {
            self.problems.push(Problem::MisplacedKeyword {
                keyword: entry.keyword,
                at: entry.key,
            });
        }
    }

    pub(super) fn read<T>(
        &mut self,
        entry: &Entry,
        expected: Expected,
        read: impl Fn(&str) -> Result<Literal<T>, Fault>,
    ) -> Option<Spanned<T>> {
        let keyword = entry.keyword;
        if entry.value.is_empty() {
            let at = entry.key;
            self.problems.push(Problem::EmptyValue { keyword, expected, at });
            return None;
        }
        match read(self.slice(entry.value)) {
            Ok(literal) => {
                self.note(entry, expected, literal.notes);
                Some(Spanned::new(literal.value, entry.value))
            }
            Err(fault) => {
                let at = entry.value;
                self.problems.push(Problem::Unreadable {
                    keyword,
                    expected,
                    fault,
                    at,
                });
                None
            }
        }
    }

    fn note(&mut self, entry: &Entry, expected: Expected, notes: Notes) {
        if notes.is_empty() {
            return;
        }
        let (keyword, at) = (entry.keyword, entry.value);
        let unusual = |note: Note| Problem::Unusual {
            keyword,
            expected,
            note,
            at,
        };
        self.problems.extend(notes.iter().map(unusual));
    }
}
