//! Why a text is not a dump.

use std::fmt;

/// Why a dump could not be read, where in its text, and what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JsonError {
    line: usize,
    column: usize,
    message: String,
    help: &'static str,
}

impl JsonError {
    pub(super) fn new(at: (usize, usize), message: impl Into<String>, help: &'static str) -> Self {
        Self {
            line: at.0,
            column: at.1,
            message: message.into(),
            help,
        }
    }

    /// The line, from 1.
    #[must_use]
    pub const fn line(&self) -> usize {
        self.line
    }

    /// The byte in the line, from 1: where the offending value ends, or where the text stops making sense.
    #[must_use]
    pub const fn column(&self) -> usize {
        self.column
    }

    /// What is wrong, one line without a full stop.
    #[must_use]
    pub fn message(&self) -> &str {
        &self.message
    }

    /// What to do about it, one line.
    #[must_use]
    pub const fn help(&self) -> &'static str {
        self.help
    }
}

impl fmt::Display for JsonError {
    /// `7:18: <message>`, to be put behind the file's name and a colon.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.line, self.column, self.message)
    }
}

impl std::error::Error for JsonError {}

impl From<serde_json::Error> for JsonError {
    fn from(error: serde_json::Error) -> Self {
        use serde_json::error::Category;
        let (line, column) = (error.line().max(1), error.column().max(1));
        let (what, help) = match error.classify() {
            Category::Eof => (
                "the dump ends in the middle: ",
                "the file is cut off; take the dump again",
            ),
            Category::Syntax => ("this is not JSON: ", "take the dump again, or mend the file by hand"),
            Category::Data | Category::Io => ("", "docs/dump-format.md describes what a dump holds"),
        };
        Self::new((line, column), format!("{what}{}", one_line(&error)), help)
    }
}

/// The message of `error` without its position, and fit for a terminal: it may quote the file.
fn one_line(error: &serde_json::Error) -> String {
    let text = error.to_string();
    let position = format!(" at line {} column {}", error.line(), error.column());
    let message = text.strip_suffix(&position).unwrap_or(&text);
    message
        .chars()
        .take(LONGEST_MESSAGE)
        .map(|c| if c.is_control() { '\u{FFFD}' } else { c })
        .collect()
}

const LONGEST_MESSAGE: usize = 200;
