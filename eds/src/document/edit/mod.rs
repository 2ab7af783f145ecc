//! Changes that leave every other byte of the file as it is.

mod apply;
mod arrange;

use std::fmt;

pub(crate) use arrange::ArrangedLine;

use super::{Document, Entry, Section};
use crate::ini;
use crate::source::{Encoding, LineEnd};
use crate::span::Span;

/// Changes to a document, made together.
///
/// All are told in places of the document as it was read, so an earlier change does not move the place of a later one.
/// Only the lines that are named change; encoding, line ends, comments and blanks stay.
///
/// ```
/// use lexican_eds::document::{Document, Keyword};
/// use lexican_eds::source::Source;
///
/// let file = "; made by hand\r\n[1017]\r\nParameterName = Heartbeat\r\nDefaultValue = 0\r\n";
/// let document = Document::read(Source::decode("pump.eds", file.into()));
/// let section = &document.sections()[0];
/// let default = section.entry(Keyword::DefaultValue).unwrap();
///
/// let mut edit = document.edit();
/// edit.set(default, "1000")?;
/// edit.insert_after(default, "LowLimit", "10")?;
/// let edited = edit.apply()?;
///
/// assert_eq!(
///     edited.to_bytes(),
///     b"; made by hand\r\n[1017]\r\nParameterName = Heartbeat\r\nDefaultValue = 1000\r\nLowLimit = 10\r\n"
/// );
/// # Ok::<(), lexican_eds::document::EditError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Edit<'a> {
    document: &'a Document,
    changes: Vec<Change>,
    byte_order_mark: bool,
    /// What all lines shall end with.
    line_end: Option<LineEnd>,
}

/// New text in place of old, both of which may be empty.
#[derive(Clone, Debug)]
struct Change {
    /// The line, from 1; 0 is before the first.
    line: u32,
    /// Within the line and its line end.
    old: Span,
    new: String,
    /// Whether it adds lines, of which any number may be added in one place.
    adds_lines: bool,
}

/// Why a change was not made.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum EditError {
    /// The text would not read back: a value with a line break or with blanks around it, a keyword with `=` in it, a
    /// section's name with `]`.
    Unreadable {
        /// The text.
        text: String,
    },
    /// The line's encoding has no byte for a character, or the line would read as another encoding.
    NotEncodable {
        /// The line, counted in the document as read.
        line: u32,
        /// Its encoding.
        encoding: Encoding,
    },
    /// Two changes of the same text.
    Conflict {
        /// The text.
        at: Span,
    },
}

impl fmt::Display for EditError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreadable { text } => write!(
                f,
                "{text:?} would not read back as it is; leave out what ends a line, a keyword or a name"
            ),
            Self::NotEncodable { line, encoding } => {
                write!(
                    f,
                    "line {line} is {} and cannot hold this text; write it in ASCII",
                    encoding.name()
                )
            }
            Self::Conflict { at } => write!(
                f,
                "two changes of the same text, bytes {} to {}; make one of them",
                at.start, at.end
            ),
        }
    }
}

impl std::error::Error for EditError {}

impl Document {
    /// Starts to change the document.
    #[must_use]
    pub fn edit(&self) -> Edit<'_> {
        Edit {
            document: self,
            changes: Vec::new(),
            byte_order_mark: self.source.byte_order_mark(),
            line_end: None,
        }
    }
}

impl Edit<'_> {
    /// Puts `value` in place of the entry's value.
    ///
    /// # Errors
    /// When `value` would not read back.
    pub fn set(&mut self, entry: &Entry, value: &str) -> Result<(), EditError> {
        let new = readable(value, true)?.to_owned();
        self.changes.push(Change {
            line: self.line(entry.key),
            old: entry.value,
            new,
            adds_lines: false,
        });
        Ok(())
    }

    /// Puts `text` in place of what stands at `at`, within one line.
    ///
    /// # Errors
    /// When `text` has a line break in it.
    pub(crate) fn replace(&mut self, at: Span, text: &str) -> Result<(), EditError> {
        if text.contains(['\r', '\n']) {
            return Err(EditError::Unreadable { text: text.to_owned() });
        }
        self.changes.push(Change {
            line: self.line(at),
            old: at,
            new: text.to_owned(),
            adds_lines: false,
        });
        Ok(())
    }

    /// Writes `text` as a comment, above the line that `at` is on.
    ///
    /// # Errors
    /// When `text` has a line break in it.
    pub(crate) fn comment_above(&mut self, at: Span, text: &str) -> Result<(), EditError> {
        if text.contains(['\r', '\n']) {
            return Err(EditError::Unreadable { text: text.to_owned() });
        }
        self.add_lines(self.line(at) - 1, &[format!("; {text}")]);
        Ok(())
    }

    /// Takes the byte order mark away.
    pub(crate) fn remove_byte_order_mark(&mut self) {
        self.byte_order_mark = false;
    }

    /// Ends every line that ends at all with `end`.
    pub(crate) fn end_lines_with(&mut self, end: LineEnd) {
        self.line_end = Some(end);
    }

    /// Writes a line below the entry, with the same blanks around key and `=`.
    ///
    /// # Errors
    /// When `key` or `value` would not read back.
    pub fn insert_after(&mut self, entry: &Entry, key: &str, value: &str) -> Result<(), EditError> {
        let source = self.document.source();
        let number = self.line(entry.key);
        let indent = source.slice(Span::new(source.line_span(number).start, entry.key.start));
        let equals = source.slice(Span::new(entry.key.end, entry.value.start));
        let line = format!("{indent}{}{equals}{}", readable_key(key)?, readable(value, true)?);
        self.add_lines(number, &[line]);
        Ok(())
    }

    /// Writes a line below the section's header.
    ///
    /// # Errors
    /// When `key` or `value` would not read back.
    pub fn insert_first(&mut self, section: &Section, key: &str, value: &str) -> Result<(), EditError> {
        self.add_lines(self.line(section.header), &[pair(key, value)?]);
        Ok(())
    }

    /// Takes the entry's line out.
    pub fn remove(&mut self, entry: &Entry) {
        self.remove_line(self.line(entry.key));
    }

    /// Takes the section out, from its header to its last entry, with the comments in between.
    pub fn remove_section(&mut self, section: &Section) {
        for line in self.line(section.header)..=self.last_line(section) {
            self.remove_line(line);
        }
    }

    /// Writes a section: below the last entry of `after`, or at the end of the file. A blank line stands before it.
    ///
    /// # Errors
    /// When `label`, a key or a value would not read back.
    pub fn add_section(
        &mut self,
        after: Option<&Section>,
        label: &str,
        entries: &[(&str, &str)],
    ) -> Result<(), EditError> {
        let source = self.document.source();
        let above = after.map_or(source.line_count(), |section| self.last_line(section));
        let blank = (!source.line_text(above).trim().is_empty()).then(String::new);
        let header = Ok(format!("[{}]", readable_label(label)?));
        let pairs = entries.iter().map(|(key, value)| pair(key, value));
        let lines = blank.map(Ok).into_iter().chain([header]).chain(pairs);
        let lines: Vec<String> = lines.collect::<Result<_, _>>()?;
        self.add_lines(above, &lines);
        Ok(())
    }

    fn line(&self, at: Span) -> u32 {
        self.document.source().line_column(at).line
    }

    fn last_line(&self, section: &Section) -> u32 {
        self.line(section.entries.last().map_or(section.header, |entry| entry.key))
    }

    fn remove_line(&mut self, line: u32) {
        self.changes.push(Change {
            line,
            old: self.document.source().whole_line(line),
            new: String::new(),
            adds_lines: false,
        });
    }

    /// Adds lines below line `above`, ended as that line is.
    fn add_lines(&mut self, above: u32, lines: &[String]) {
        let source = self.document.source();
        let end = match (source.line_end(above), source.line_end(1)) {
            (LineEnd::None, LineEnd::None) => LineEnd::Lf,
            (LineEnd::None, end) | (end, _) => end,
        };
        let text = lines.join(end.text());
        let at = source.whole_line(above).end;
        self.changes.push(Change {
            line: above,
            old: Span::new(at, at),
            new: if above > 0 && source.line_end(above) == LineEnd::None {
                format!("{}{text}", end.text())
            } else {
                format!("{text}{}", end.text())
            },
            adds_lines: true,
        });
    }
}

fn pair(key: &str, value: &str) -> Result<String, EditError> {
    Ok(format!("{}={}", readable_key(key)?, readable(value, true)?))
}

fn readable_key(key: &str) -> Result<&str, EditError> {
    let fits = !key.contains('=') && !key.starts_with([';', '#', '[']);
    readable(key, fits && !key.is_empty())
}

fn readable_label(label: &str) -> Result<&str, EditError> {
    readable(label, !label.contains(']'))
}

/// `text`, when it `fits`, and neither ends the line nor loses a blank when it is read.
fn readable(text: &str, fits: bool) -> Result<&str, EditError> {
    let keeps = !text.contains(['\r', '\n']) && ini::trim(text) == text;
    if fits && keeps {
        Ok(text)
    } else {
        Err(EditError::Unreadable { text: text.to_owned() })
    }
}
