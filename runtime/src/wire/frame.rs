//! A CAN frame.

use core::fmt;

use super::CanId;

/// Set in the header of a remote frame.
const REMOTE: u32 = 1 << 30;

/// A classic CAN frame: a data frame of up to 8 bytes, or a remote frame.
///
/// Identifier, its length and RTR are one word, so that finding the service that a frame is for is comparing one number.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Frame {
    header: u32,
    length: u8,
    /// Zero beyond `length`.
    data: [u8; 8],
}

impl Frame {
    /// A data frame; `None` when `data` is longer than 8 bytes.
    #[must_use]
    pub fn new(id: CanId, data: &[u8]) -> Option<Self> {
        if data.len() > 8 {
            return None;
        }
        // So few bytes cost less one by one than a call that copies them.
        let word = data.iter().rfold(0, |word, byte| word << 8 | u64::from(*byte));
        Some(Self::from_word(id, word, u8::try_from(data.len()).ok()?))
    }

    /// A data frame of eight bytes.
    #[inline]
    #[must_use]
    pub const fn full(id: CanId, data: [u8; 8]) -> Self {
        Self {
            header: id.bits(),
            length: 8,
            data,
        }
    }

    /// A data frame of one byte.
    #[must_use]
    pub const fn byte(id: CanId, byte: u8) -> Self {
        Self {
            header: id.bits(),
            length: 1,
            data: [byte, 0, 0, 0, 0, 0, 0, 0],
        }
    }

    /// A data frame of `length` bytes, at most 8: those of `word`, the lowest first, the rest of which is to be 0.
    #[inline]
    #[must_use]
    pub const fn from_word(id: CanId, word: u64, length: u8) -> Self {
        Self {
            header: id.bits(),
            length: if length > 8 { 8 } else { length },
            data: word.to_le_bytes(),
        }
    }

    /// A remote frame that asks for `length` bytes; `None` above 8.
    #[must_use]
    pub const fn remote(id: CanId, length: u8) -> Option<Self> {
        match length {
            0..=8 => Some(Self {
                header: id.bits() | REMOTE,
                length,
                data: [0; 8],
            }),
            _ => None,
        }
    }

    /// The identifier.
    #[must_use]
    pub const fn id(&self) -> CanId {
        CanId::from_bits(self.header & !REMOTE)
    }

    /// Whether it is a remote frame (RTR): then it has a length but no data.
    #[must_use]
    pub const fn is_remote(&self) -> bool {
        self.header & REMOTE != 0
    }

    /// The data length code, 0 to 8.
    #[must_use]
    pub const fn length(&self) -> usize {
        self.length as usize
    }

    /// The data, 0 to 8 bytes; none of a remote frame.
    #[must_use]
    pub fn data(&self) -> &[u8] {
        let length = if self.is_remote() { 0 } else { self.length() };
        self.data.get(..length).unwrap_or(&self.data)
    }

    /// The data as a number, the first byte the lowest; 0 beyond the length.
    #[inline]
    #[must_use]
    pub const fn word(&self) -> u64 {
        u64::from_le_bytes(self.data)
    }

    /// The identifier of a data frame; `None` of a remote one.
    #[inline]
    #[must_use]
    pub const fn data_id(&self) -> Option<CanId> {
        if self.is_remote() {
            return None;
        }
        Some(CanId::from_bits(self.header))
    }

    /// The data of a data frame of eight bytes; `None` of any other.
    #[inline]
    #[must_use]
    pub const fn full_data(&self) -> Option<[u8; 8]> {
        if self.length == 8 && !self.is_remote() {
            return Some(self.data);
        }
        None
    }
}

impl fmt::Debug for Frame {
    /// As the tools of can-utils write it: `601#4000100000000000`, `704#R1`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = if self.id().is_extended() { 8 } else { 3 };
        write!(f, "{:0width$X}#", self.id().number())?;
        if self.is_remote() {
            write!(f, "R{}", self.length)?;
        }
        self.data().iter().try_for_each(|byte| write!(f, "{byte:02X}"))
    }
}
