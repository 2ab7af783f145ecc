//! The canonical form of a file: one order, one spelling, every comment with what it belongs to.
//!
//! | what | how |
//! |---|---|
//! | sections | facts about file and device, each list before its objects, each object before its sub-objects, modules, tools; a blank line between them |
//! | keywords | in the order of the standard's tables, `Keyword=value` without blanks |
//! | names | as the standard spells them |
//! | numbers | `0x` and capital digits, no more of them than the type has; indices and data types with four; decimal stays decimal |
//! | lists | numbered 1, 2, 3 … and counted |
//! | comments | above the line that they stand above; those at the top of the file stay there; those that a blank line parts from the next section stay with the one before |
//! | line ends | all alike, those that prevail |
//!
//! The device stays what it is. Encoding and the text of comments stay byte for byte.

mod layout;
mod value;

use crate::{
    Reading,
    diagnostic::Level,
    document::{Document, EditError},
    fix,
    rules::{self, LevelChange, Levels},
};

/// The rules whose fixes are a matter of form alone.
const RULES: [&str; 18] = [
    "INI007", "INI008", "INI011", "INI012", "INI013", "EDS005", "EDS009", "EDS011", "EDS012", "EDS014", "EDS024",
    "EDS025", "EDS026", "OBJ012", "OBJ013", "OBJ014", "OBJ023", "OBJ024",
];

/// How often the form is looked at again: a section that comes to stand before its like can be the one that counts.
const MOST_PASSES: usize = 4;

/// The same file in its canonical form. A file without sections stays as it is.
///
/// ```
/// let file = "[1017]\ndatatype = 0x6\n; set by the user\nParameterName = Heartbeat\n[DeviceInfo]\nNrOfRxPDO=0x0\n";
/// let formatted = lexican_eds::format::format(lexican_eds::read("pump.eds", file.into()))?;
///
/// let canonical = "[DeviceInfo]\nNrOfRXPDO=0x0\n\n[1017]\n; set by the user\nParameterName=Heartbeat\nDataType=0x0006\n";
/// assert_eq!(formatted.document.to_bytes(), canonical.as_bytes());
/// # Ok::<(), lexican_eds::document::EditError>(())
/// ```
///
/// # Errors
/// When the lines would be read in another encoding in the new order.
pub fn format(mut reading: Reading) -> Result<Reading, EditError> {
    let levels = levels();
    for _ in 0..MOST_PASSES {
        let mended = fix::mend(reading.clone(), |reading| rules::check(reading, &levels)).reading;
        let lines = layout::lines(&mended);
        let next = crate::read_document(arranged(&mended.document, &lines)?);
        let done = next.document.to_bytes() == reading.document.to_bytes();
        reading = next;
        if done {
            break;
        }
    }
    Ok(reading)
}

fn arranged(document: &Document, lines: &[crate::document::ArrangedLine]) -> Result<Document, EditError> {
    if document.sections().is_empty() {
        return Ok(document.clone());
    }
    document.arranged(lines)
}

/// Those rules alone, at the level that they have.
fn levels() -> Levels {
    let silent = rules::families().iter().map(|family| (family.letters, Level::Allow));
    let heard = RULES.map(|code| (code, Level::Note));
    let changes = silent
        .chain(heard)
        .map(|(selector, level)| LevelChange::new(selector, level));
    changes.flatten().fold(Levels::default(), Levels::with)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_rule_of_form_exists_and_has_a_fix() {
        for code in RULES {
            let rule = rules::find(code);
            assert!(
                rule.is_some_and(|rule| rule.fixable() != rules::Fixable::Never),
                "{code}"
            );
        }
    }
}
