//! SDO (CiA 301, 7.2.4.3): eight bytes each way, 600h + node-ID from the client, 580h + node-ID from the server.
//!
//! Byte 0 is the command; bytes 1 to 3 are the multiplexer (index, low byte first, then sub-index) in what opens or
//! aborts a transfer. *Download* is the client writing, *upload* is the client reading.

mod block;
mod request;
pub(crate) mod response;

pub use block::BlockSegment;
pub use request::Request;
pub use response::Response;

use crate::Address;

/// Up to four bytes that stand in the initiating message itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Expedited {
    /// The bytes, as a little-endian number. Beyond `length` they mean nothing.
    pub bits: u32,
    /// How many of them count, 1 to 4; `None` when the sender did not say.
    pub length: Option<u8>,
}

/// Up to seven bytes of a longer value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Segment {
    /// Alternates from segment to segment, beginning with `false`.
    pub toggle: bool,
    /// Whether no segment follows.
    pub last: bool,
    /// How many of `data` count, 0 to 7.
    pub length: u8,
    /// The bytes. Beyond `length` they mean nothing.
    pub data: [u8; 7],
}

impl Segment {
    /// The bytes that count.
    #[inline]
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        self.data.get(..usize::from(self.length)).unwrap_or(&self.data)
    }

    /// Bits 4 to 1 of byte 0 are toggle and the number of bytes without meaning, bit 0 is `last`.
    #[inline]
    fn parse([command, data @ ..]: [u8; 8]) -> Self {
        Self {
            toggle: command & 0x10 != 0,
            last: command & 0x01 != 0,
            length: 7 - (command >> 1 & 0x07),
            data,
        }
    }

    /// See [`Segment::parse`]; `specifier` is what stands in bits 7 to 5.
    #[inline]
    fn emit(self, specifier: u8) -> [u8; 8] {
        let unused = 7u8.saturating_sub(self.length);
        let command = specifier | u8::from(self.toggle) << 4 | unused << 1 | u8::from(self.last);
        let [d0, d1, d2, d3, d4, d5, d6] = self.data;
        [command, d0, d1, d2, d3, d4, d5, d6]
    }
}

impl Expedited {
    /// Bits 3 to 0 of the command: bytes without meaning, expedited, size indicated.
    #[inline]
    fn command(self) -> u8 {
        match self.length {
            Some(length) => 0x03 | (4u8.saturating_sub(length) & 0x03) << 2,
            None => 0x02,
        }
    }
}

/// Multiplexer and the four bytes behind it.
#[inline]
#[allow(clippy::cast_possible_truncation)] // Each is a part of the eight bytes.
fn split(bytes: [u8; 8]) -> (Address, u32) {
    let bits = u64::from_le_bytes(bytes);
    (
        Address::new((bits >> 8) as u16, (bits >> 24) as u8),
        (bits >> 32) as u32,
    )
}

/// Command, multiplexer and the four bytes behind it.
#[inline]
fn join(command: u8, address: Address, word: u32) -> [u8; 8] {
    let head = u32::from(command) | u32::from(address.index) << 8 | u32::from(address.sub) << 24;
    (u64::from(word) << 32 | u64::from(head)).to_le_bytes()
}
