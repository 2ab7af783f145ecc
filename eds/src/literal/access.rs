//! AccessType.

use super::{Fault, Literal, Note, without_comment};
use crate::ir::AccessType;

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

fn unusual(value: AccessType, note: Note) -> Literal<AccessType> {
    Literal {
        value,
        notes: note.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::{AccessType, Fault, Note, access};
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
        assert_eq!(access("R"), Ok(super::unusual(AccessType::Ro, Note::Abbreviation)));
        assert_eq!(access("W"), Ok(super::unusual(AccessType::Wo, Note::Abbreviation)));
    }

    #[test]
    fn other_words_are_refused() {
        for text in ["", "X", "UNKNOWN", "r w", "readonly"] {
            assert_eq!(access(text), Err(Fault::UnknownWord), "{text}");
        }
    }
}
