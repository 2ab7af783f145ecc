//! Why there is no value.

use std::fmt;

use lexican_eds::dump;
use lexican_runtime::AbortCode;

/// Why a transfer came to nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure {
    /// The server refused.
    Refused(AbortCode),
    /// The server broke the protocol, and was told so with this code.
    Broken(AbortCode),
    /// No answer came in time.
    Silent {
        /// What the client waited for, as it follows on "no": `answer to the request`.
        awaited: &'static str,
    },
    /// The node booted during the transfer.
    Rebooted,
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused(code) => write!(f, "the node refuses: {}", dump::AbortCode(code.0)),
            Self::Broken(code) => write!(f, "the node broke the protocol: {}", dump::AbortCode(code.0)),
            Self::Silent { awaited } => write!(f, "no {awaited} came in time"),
            Self::Rebooted => f.write_str("the node booted during the transfer"),
        }
    }
}

impl std::error::Error for Failure {}
