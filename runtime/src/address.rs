//! Where a value stands in the object dictionary.

use core::fmt;

/// Index and sub-index of a value. CiA 301 calls this pair the multiplexer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Address {
    /// The object's index, `0x0000..=0xFFFF`.
    pub index: u16,
    /// The sub-index, `0x00..=0xFF`; 0 for an object without sub-indices.
    pub sub: u8,
}

impl Address {
    /// The address of `index` and `sub`.
    #[must_use]
    pub const fn new(index: u16, sub: u8) -> Self {
        Self { index, sub }
    }

    /// Index and sub-index as one number, the index in the high bits: the order of a dictionary.
    #[must_use]
    pub const fn key(self) -> u32 {
        (self.index as u32) << 8 | self.sub as u32
    }
}

impl fmt::Display for Address {
    /// `1018sub1`, as an EDS file names it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:04X}sub{:X}", self.index, self.sub)
    }
}
