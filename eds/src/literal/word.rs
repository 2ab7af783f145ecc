//! Words: access types, and names that stand for numbers.

use super::{Fault, Literal, Note, unsigned, without_comment};
use crate::ir::{AccessType, DataType, ObjectCode};

const ALL: [AccessType; 6] = [
    AccessType::Ro,
    AccessType::Rw,
    AccessType::Const,
    AccessType::Rww,
    AccessType::Rwr,
    AccessType::Wo,
];

/// Reads an access type in any case; `R` and `W` stand for `ro` and `wo`.
///
/// # Errors
///
/// [`Fault::UnknownWord`]
pub fn access(text: &str) -> Result<Literal<AccessType>, Fault> {
    without_comment(text, |text| {
        let is_named = |access: &&AccessType| access.name().eq_ignore_ascii_case(text);
        match (ALL.iter().find(is_named), text) {
            (Some(&value), _) if text == value.name() => Ok(Literal::plain(value)),
            (Some(&value), _) => Ok(unusual(value, Note::LetterCase)),
            (None, "R" | "r") => Ok(unusual(AccessType::Ro, Note::Abbreviation)),
            (None, "W" | "w") => Ok(unusual(AccessType::Wo, Note::Abbreviation)),
            _ => Err(Fault::UnknownWord),
        }
    })
}

/// Reads the number of an object code, or its name in the standard: `0x7`, `VAR`.
///
/// # Errors
///
/// Why `text` is no object code; [`Fault::OutOfRange`] for a number that CiA 301 does not define.
pub fn object_code(text: &str) -> Result<Literal<ObjectCode>, Fault> {
    number_or_name(text, u8::MAX.into(), ObjectCode::from_name, |number| {
        u8::try_from(number).ok().and_then(ObjectCode::from_number)
    })
}

/// Reads the index of a data type, defined or not, or its name in the standard: `0x0007`, `UNSIGNED32`.
///
/// # Errors
///
/// Why `text` is no index.
pub fn data_type(text: &str) -> Result<Literal<u16>, Fault> {
    let of_name = |name: &str| DataType::from_name(name).map(DataType::index);
    number_or_name(text, u16::MAX.into(), of_name, |number| u16::try_from(number).ok())
}

fn number_or_name<T>(
    text: &str,
    max: u64,
    of_name: impl Fn(&str) -> Option<T>,
    of_number: impl Fn(u64) -> Option<T>,
) -> Result<Literal<T>, Fault> {
    let number = match unsigned(text, max) {
        Ok(number) => number,
        Err(fault) => {
            let named = |text: &str| of_name(text).map(|value| unusual(value, Note::Name)).ok_or(fault);
            return without_comment(text, named);
        }
    };
    let value = of_number(number.value).ok_or(Fault::OutOfRange)?;
    Ok(number.map(|_| value))
}

fn unusual<T>(value: T, note: Note) -> Literal<T> {
    Literal {
        value,
        notes: note.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::{AccessType, DataType, Fault, Note, ObjectCode, access, data_type, object_code, unusual};
    use crate::literal::Notes;

    #[test]
    fn an_access_type_is_read_in_any_case_and_another_case_is_noted() {
        assert!(access("const").unwrap().notes.is_empty());
        let literal = access("RWw").unwrap();
        assert_eq!(
            (literal.value, literal.notes),
            (AccessType::Rww, Note::LetterCase.into())
        );
    }

    #[test]
    fn a_comment_behind_it_is_noted() {
        let literal = access("RO # Index 1200h:               const").unwrap();
        assert_eq!(literal.value, AccessType::Ro);
        assert_eq!(
            literal.notes,
            Notes::from(Note::LetterCase).and(Note::TrailingComment.into())
        );
    }

    #[test]
    fn one_letter_is_read_and_noted() {
        assert_eq!(access("R"), Ok(unusual(AccessType::Ro, Note::Abbreviation)));
        assert_eq!(access("W"), Ok(unusual(AccessType::Wo, Note::Abbreviation)));
    }

    #[test]
    fn other_words_are_refused() {
        for text in ["", "X", "UNKNOWN", "r w", "readonly"] {
            assert_eq!(access(text), Err(Fault::UnknownWord), "{text}");
        }
    }

    #[test]
    fn a_name_of_the_standard_stands_for_its_number_and_is_noted() {
        assert_eq!(object_code("ARRAY"), Ok(unusual(ObjectCode::Array, Note::Name)));
        assert_eq!(
            data_type("unsigned32"),
            Ok(unusual(DataType::Unsigned32.index(), Note::Name))
        );
        assert_eq!(object_code("0x08").unwrap().value, ObjectCode::Array);
        assert_eq!(data_type("0x40").unwrap().value, 0x40);
    }

    #[test]
    fn a_number_that_means_nothing_is_refused() {
        assert_eq!(object_code("0x71"), Err(Fault::OutOfRange));
        assert_eq!(object_code("VARIABLE"), Err(Fault::NotANumber));
        assert_eq!(data_type("0x10000"), Err(Fault::OutOfRange));
    }
}
