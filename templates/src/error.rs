//! Why a template could not be rendered.

use std::fmt;

use crate::Template;

/// A template is not one, or asks for what the context does not have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    name: String,
    line: Option<usize>,
    message: String,
}

impl Error {
    pub(crate) fn new(template: &Template<'_>, error: &minijinja::Error) -> Self {
        let message = match error.detail() {
            Some(detail) => format!("{}: {detail}", error.kind()),
            None => error.kind().to_string(),
        };
        Self {
            name: template.name.to_owned(),
            line: error.line(),
            message,
        }
    }
}

impl fmt::Display for Error {
    /// `report.j2:12: undefined value`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)?;
        if let Some(line) = self.line {
            write!(f, ":{line}")?;
        }
        write!(f, ": {}", self.message)
    }
}

impl std::error::Error for Error {}
