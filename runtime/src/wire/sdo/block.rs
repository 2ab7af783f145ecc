//! What block download and block upload have in common (CiA 301, 7.2.4.3.9 and 7.2.4.3.13).

/// Seven bytes of a value that goes in blocks, from the side that has it.
///
/// Nothing but the state of both sides tells it from a [`Request`](super::Request) or [`Response`](super::Response), but
/// for an abort message: that one would be the last segment with the sequence number 0, which does not exist.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlockSegment {
    /// Whether no segment follows.
    pub last: bool,
    /// Its number in the block, 1 to 127.
    pub sequence: u8,
    /// The bytes. How many of the last segment's count is said when the transfer ends.
    pub data: [u8; 7],
}

impl BlockSegment {
    /// Bit 7 of byte 0 is `last`, bits 6 to 0 are the sequence number.
    #[inline]
    #[must_use]
    pub const fn parse([command, data @ ..]: [u8; 8]) -> Self {
        Self {
            last: command & 0x80 != 0,
            sequence: command & 0x7F,
            data,
        }
    }

    /// Whether it is no segment but an abort message, `80`.
    #[inline]
    #[must_use]
    pub const fn is_abort(self) -> bool {
        self.last && self.sequence == 0
    }

    /// The eight bytes.
    #[inline]
    #[must_use]
    pub const fn emit(self) -> [u8; 8] {
        let [d0, d1, d2, d3, d4, d5, d6] = self.data;
        let last = if self.last { 0x80 } else { 0x00 };
        [last | self.sequence & 0x7F, d0, d1, d2, d3, d4, d5, d6]
    }
}

/// `110nnn01` and the CRC, which the client says of a download and the server of an upload.
pub(super) const fn emit_end(unused: u8, crc: u16) -> [u8; 8] {
    let [low, high] = crc.to_le_bytes();
    [0xC1 | (unused & 0x07) << 2, low, high, 0, 0, 0, 0, 0]
}
