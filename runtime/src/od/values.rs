//! The field types of a generated dictionary that Rust has no plain type for.

use bytemuck::{Pod, Zeroable};

/// BOOLEAN: one byte, 0 for false (CiA 301, 7.1.4.2). Any other byte counts as true.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(transparent)]
pub struct Boolean(u8);

impl Boolean {
    /// The BOOLEAN of `value`.
    #[must_use]
    pub const fn new(value: bool) -> Self {
        Self(value as u8)
    }

    /// The truth value.
    #[must_use]
    pub const fn get(self) -> bool {
        self.0 != 0
    }
}

impl From<bool> for Boolean {
    fn from(value: bool) -> Self {
        Self::new(value)
    }
}

/// OCTET_STRING, UNICODE_STRING or a buffered DOMAIN of up to `N` bytes.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C, packed)]
pub struct OctetString<const N: usize> {
    length: [u8; 2],
    bytes: [u8; N],
}

/// VISIBLE_STRING of up to `N` bytes (CiA 301, 7.1.4.6: characters 20h to 7Eh).
pub type VisibleString<const N: usize> = OctetString<N>;

/// TIME_OF_DAY or TIME_DIFFERENCE, six bytes as on the bus (CiA 301, 7.1.6.3).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(transparent)]
pub struct TimeOfDay([u8; 6]);
