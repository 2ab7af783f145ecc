//! One answer.

use super::AbortCode;

/// What came of reading one address.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// The bytes that were uploaded, in the order of the bus; may be none.
    Value(Vec<u8>),
    /// What the transfer was ended with, by the device or by the client.
    Abort(AbortCode),
    /// No answer came in the client's time.
    Timeout,
}

impl Answer {
    /// The bytes, where there are any.
    #[must_use]
    pub fn value(&self) -> Option<&[u8]> {
        match self {
            Self::Value(bytes) => Some(bytes),
            Self::Abort(_) | Self::Timeout => None,
        }
    }

    /// Whether the device said that there is nothing at the address: no such object or no such sub-index.
    #[must_use]
    pub const fn is_absence(&self) -> bool {
        matches!(
            self,
            Self::Abort(AbortCode::NO_SUCH_OBJECT | AbortCode::NO_SUCH_SUB_INDEX)
        )
    }
}
