//! Why a bus cannot be reached.

use std::{fmt, io};

/// A bus that cannot be opened, or is gone.
#[derive(Debug)]
pub struct Error {
    /// The bus as the user named it, such as `slcan+tcp://localhost:4711`.
    pub bus: String,
    /// What could not be done, as it follows on "cannot": `open`, `send a frame`.
    pub what: &'static str,
    /// What the system says.
    pub cause: io::Error,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: cannot {}: {}", self.bus, self.what, self.cause)
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.cause)
    }
}
