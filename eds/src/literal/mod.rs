//! What stands to the right of the `=`: numbers, formulas, reals, texts, bytes, times.
//!
//! Nothing here knows of sections or keywords. Each function takes the trimmed text of one value and gives what it means,
//! with [`Notes`] on an unusual way of writing it, or a [`Fault`] that says why it cannot be read. What is accepted:
//!
//! | kind | accepted |
//! |---|---|
//! | integer | decimal, `0x` hex in any case, octal by a leading 0, a sign before any of them, C's suffixes `U` and `L` |
//! | formula | `$NODEID`, `$NODEID+n`, `n+$NODEID`, with blanks and in any case, with or without the `$` |
//! | real | decimal text with or without exponent and suffix `f`; hex as the IEEE 754 pattern when it has all its digits |
//! | text | as written, without one pair of double quotes around it |
//! | bytes | pairs of hex digits, with or without blanks and a leading `0x` |
//! | access type | `ro`, `rw`, `wo`, `rwr`, `rww`, `const` in any case, `R`, `W` |
//! | object code, data type | a number, or the standard's name for it |
//! | time | `days milliseconds`, or one number of 48 bits |
//!
//! A comment after the value (`0x0007 # UNSIGNED32`, `5 ; ms`) is left out where a `#` or `;` cannot be part of it, that
//! is everywhere but in texts.

mod bytes;
mod note;
mod number;
mod real;
mod value;
mod word;

pub use note::{Fault, Note, Notes};
pub use number::{Integer, Number, Radix, integer, number};
pub use value::{text, unsigned, value};
pub use word::{access, data_type, object_code};

/// A value and how it was written.
#[derive(Clone, Debug, PartialEq)]
pub struct Literal<T> {
    /// What the text means.
    pub value: T,
    /// What is unusual about the way it is written.
    pub notes: Notes,
}

impl<T> Literal<T> {
    /// A value written the ordinary way.
    #[must_use]
    pub const fn plain(value: T) -> Self {
        Self {
            value,
            notes: Notes::NONE,
        }
    }

    /// The same notes, another value.
    pub fn map<U>(self, f: impl FnOnce(T) -> U) -> Literal<U> {
        Literal {
            value: f(self.value),
            notes: self.notes,
        }
    }
}

/// `text` without a comment behind it. Not for texts, which may have `#` and `;` in them.
pub(crate) fn bare(text: &str) -> &str {
    text.split(['#', ';']).next().unwrap_or_default().trim_end()
}

/// Reads `text` by `read`; if that fails and a comment follows the value, reads what stands before the comment.
///
/// # Errors
///
/// The fault of the first attempt when there is no comment, else that of the second.
fn without_comment<T>(text: &str, read: impl Fn(&str) -> Result<Literal<T>, Fault>) -> Result<Literal<T>, Fault> {
    read(text).or_else(|fault| {
        let (value, _) = text.split_once(['#', ';']).ok_or(fault)?;
        let mut literal = read(value.trim_end())?;
        literal.notes.add(Note::TrailingComment);
        Ok(literal)
    })
}
