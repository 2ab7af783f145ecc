//! The field types of a generated dictionary that Rust has no plain type for.

use core::fmt;

use bytemuck::{Pod, Zeroable};

use crate::AbortCode;

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

/// OCTET_STRING, UNICODE_STRING or a buffered DOMAIN of up to `N` bytes, `N` up to 65,535.
///
/// It has a length of its own, so a client may write a shorter string than the one that stood there.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C, packed)]
pub struct OctetString<const N: usize> {
    /// Little-endian on every target, so that the field needs no alignment.
    length: [u8; 2],
    bytes: [u8; N],
}

/// VISIBLE_STRING of up to `N` bytes (CiA 301, 7.1.4.6: characters 20h to 7Eh).
pub type VisibleString<const N: usize> = OctetString<N>;

impl<const N: usize> OctetString<N> {
    /// The string of no bytes.
    pub const EMPTY: Self = Self::new(&[]);

    /// A string of these bytes; what does not fit into `N` is cut off.
    #[must_use]
    pub const fn new(value: &[u8]) -> Self {
        let mut bytes = [0; N];
        let mut length: u16 = 0;
        while (length as usize) < N && (length as usize) < value.len() && length < u16::MAX {
            bytes[length as usize] = value[length as usize];
            length += 1;
        }
        Self {
            length: length.to_le_bytes(),
            bytes,
        }
    }

    /// The most bytes that it can hold.
    #[must_use]
    pub const fn capacity(&self) -> usize {
        N
    }

    /// The bytes that it holds now.
    #[must_use]
    pub fn as_bytes(&self) -> &[u8] {
        let length = usize::from(u16::from_le_bytes(self.length));
        // Through the bytes of the whole: Rust refuses a reference to a field of a packed struct, even one of bytes.
        let (_, bytes) = bytemuck::bytes_of(self).split_at(2);
        bytes.get(..length).unwrap_or(bytes)
    }

    /// The text that it holds now; `None` when that is not UTF-8 (plain ASCII is).
    #[must_use]
    pub fn as_str(&self) -> Option<&str> {
        core::str::from_utf8(self.as_bytes()).ok()
    }

    /// Replaces what it holds.
    ///
    /// # Errors
    /// [`AbortCode::TOO_LONG`] when `value` is longer than the capacity; then nothing has changed.
    pub fn set(&mut self, value: &[u8]) -> Result<(), AbortCode> {
        let length = u16::try_from(value.len()).map_err(|_| AbortCode::TOO_LONG)?;
        let (length_bytes, bytes) = bytemuck::bytes_of_mut(self).split_at_mut(2);
        bytes
            .get_mut(..value.len())
            .ok_or(AbortCode::TOO_LONG)?
            .copy_from_slice(value);
        length_bytes.copy_from_slice(&length.to_le_bytes());
        Ok(())
    }
}

impl<const N: usize> Default for OctetString<N> {
    fn default() -> Self {
        Self::EMPTY
    }
}

impl<const N: usize> PartialEq for OctetString<N> {
    fn eq(&self, other: &Self) -> bool {
        self.as_bytes() == other.as_bytes()
    }
}

impl<const N: usize> Eq for OctetString<N> {}

impl<const N: usize> fmt::Debug for OctetString<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.as_str() {
            Some(text) => fmt::Debug::fmt(text, f),
            None => fmt::Debug::fmt(self.as_bytes(), f),
        }
    }
}

/// TIME_OF_DAY or TIME_DIFFERENCE, six bytes as on the bus (CiA 301, 7.1.6.3 and 7.1.6.4).
#[derive(Clone, Copy, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(transparent)]
pub struct TimeOfDay([u8; 6]);

impl TimeOfDay {
    /// The time `milliseconds` (after midnight, 28 bits; higher ones are dropped) on day `days` (since 1 January 1984).
    #[must_use]
    pub const fn new(days: u16, milliseconds: u32) -> Self {
        let [m0, m1, m2, m3] = (milliseconds & 0x0FFF_FFFF).to_le_bytes();
        let [d0, d1] = days.to_le_bytes();
        Self([m0, m1, m2, m3, d0, d1])
    }

    /// Days since 1 January 1984; of a TIME_DIFFERENCE whole days.
    #[must_use]
    pub const fn days(self) -> u16 {
        let [_, _, _, _, d0, d1] = self.0;
        u16::from_le_bytes([d0, d1])
    }

    /// Milliseconds after midnight, or beyond the whole days: 28 bits.
    #[must_use]
    pub const fn milliseconds(self) -> u32 {
        let [m0, m1, m2, m3, ..] = self.0;
        u32::from_le_bytes([m0, m1, m2, m3]) & 0x0FFF_FFFF
    }

    /// The time that six bytes say, as on the bus; the four highest bits of the milliseconds are reserved, and kept.
    #[must_use]
    pub const fn from_bytes(bytes: [u8; 6]) -> Self {
        Self(bytes)
    }

    /// The six bytes, as on the bus.
    #[must_use]
    pub const fn to_bytes(self) -> [u8; 6] {
        self.0
    }
}

impl fmt::Debug for TimeOfDay {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} d {} ms", self.days(), self.milliseconds())
    }
}

/// Sets the element of an ARRAY's field that stands for `sub`, 1 for the first; another `sub` changes nothing.
///
/// Generated code stores by it what a handler of an ARRAY gives.
pub fn set_element<T>(array: &mut [T], sub: u8, value: T) {
    if let Some(element) = usize::from(sub).checked_sub(1).and_then(|at| array.get_mut(at)) {
        *element = value;
    }
}
