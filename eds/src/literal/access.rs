//! AccessType.

use super::{Fault, Literal, Note, Notes, without_comment};
use crate::ir::AccessType;

const ALL: [AccessType; 6] = [
    AccessType::Ro,
    AccessType::Rw,
    AccessType::Const,
    AccessType::Rww,
    AccessType::Rwr,
    AccessType::Wo,
];

/// Reads an access type in any case.
///
/// # Errors
///
/// [`Fault::UnknownWord`]
pub fn access(text: &str) -> Result<Literal<AccessType>, Fault> {
    without_comment(text, |text| {
        let is_named = |access: &&AccessType| access.name().eq_ignore_ascii_case(text);
        let value = *ALL.iter().find(is_named).ok_or(Fault::UnknownWord)?;
        let notes = if text == value.name() {
            Notes::NONE
        } else {
            Note::LetterCase.into()
        };
        Ok(Literal { value, notes })
    })
}

#[cfg(test)]
mod tests {
    use super::{AccessType, Fault, Note, Notes, access};

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
    fn other_words_are_refused() {
        for text in ["", "R", "UNKNOWN", "r w", "readonly"] {
            assert_eq!(access(text), Err(Fault::UnknownWord), "{text}");
        }
    }
}
