//! One answer.

/// What came of reading one address.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// The bytes that were uploaded, in the order of the bus; may be none.
    Value(Vec<u8>),
    /// The SDO abort code (CiA 301, table 22) that ended the transfer.
    Abort(u32),
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

    /// Whether the device said that there is nothing at the address: 0602 0000h (no such object) or 0609 0011h (no such
    /// sub-index).
    #[must_use]
    pub const fn is_absence(&self) -> bool {
        matches!(self, Self::Abort(0x0602_0000 | 0x0609_0011))
    }
}
