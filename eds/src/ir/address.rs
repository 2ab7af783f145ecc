//! Index and sub-index, node-ID.

use std::fmt;

/// Index and sub-index of a value. CiA 301 calls this pair the multiplexer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Address {
    /// The object's index, `0x0000..=0xFFFF`.
    pub index: u16,
    /// The sub-index, 0 for an object without sub-indices.
    pub sub: u8,
}

impl Address {
    /// The address of `index` and `sub`.
    #[must_use]
    pub const fn new(index: u16, sub: u8) -> Self {
        Self { index, sub }
    }
}

impl fmt::Display for Address {
    /// `1018sub1`: as a section of an EDS is named.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:04X}sub{:X}", self.index, self.sub)
    }
}

/// A node's number on its network, 1 to 127 (CiA 301, 4.5.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(u8);

impl NodeId {
    /// The node-ID `value`; `None` outside 1 to 127.
    #[must_use]
    pub const fn new(value: u8) -> Option<Self> {
        match value {
            1..=127 => Some(Self(value)),
            _ => None,
        }
    }

    /// The number, 1 to 127.
    #[must_use]
    pub const fn get(self) -> u8 {
        self.0
    }
}
