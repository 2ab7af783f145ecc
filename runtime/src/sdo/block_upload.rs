//! Block upload: the client reads, up to 127 segments for each request.
//!
//! ```text
//! A4 08 10 00 7F 00 00 00 ─▶     ◀─ C6 08 10 00 0A 00 00 00     blocks of 127 segments, please; ten bytes, with a CRC
//! A3 00 00 00 00 00 00 00 ─▶     ◀─ 01 61 62 63 64 65 66 67     the first segment of the block
//!                                ◀─ 82 68 69 6A 00 00 00 00     bit 7: the last
//! A2 02 7F 00 00 00 00 00 ─▶     ◀─ D1 2A A3 00 00 00 00 00     four bytes of the last do not count; the CRC is A32Ah
//! A1 00 00 00 00 00 00 00 ─▶
//! ```

use super::outgoing::Outgoing;
use crate::{
    od::Device,
    wire::sdo::{response, Response},
    AbortCode,
};

/// Blocks are going out.
#[derive(Clone, Copy, Debug)]
pub(super) struct BlockUpload {
    pub(super) outgoing: Outgoing,
    phase: Phase,
    /// Segments of this block.
    block_size: u8,
    /// The number of the last segment sent of this block.
    sequence: u8,
    /// Bytes of that segment that do not count.
    unused: u8,
    /// Where this block began.
    confirmed: usize,
}

/// What comes next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    /// The client starts: `A3`.
    Start,
    /// Segments are sent; the client may acknowledge them.
    Send,
    /// The client acknowledges: `A2`.
    Acknowledge,
    /// The client ends the transfer: `A1`.
    End,
}

/// Refuses a number of segments that no block has.
pub(super) const fn check_block_size(block_size: u8) -> Result<(), AbortCode> {
    match block_size {
        1..=127 => Ok(()),
        _ => Err(AbortCode::INVALID_BLOCK_SIZE),
    }
}

impl BlockUpload {
    /// Takes `A0` or `A4`.
    pub(super) const fn begin(outgoing: Outgoing, block_size: u8) -> Self {
        Self {
            outgoing,
            phase: Phase::Start,
            block_size,
            sequence: 0,
            unused: 0,
            confirmed: 0,
        }
    }

    /// Whether a segment is to be sent.
    #[inline]
    pub(super) fn is_sending(&self) -> bool {
        self.phase == Phase::Send
    }

    /// Takes `A3`.
    pub(super) fn start(&mut self) -> Result<(), AbortCode> {
        if self.phase != Phase::Start {
            return Err(AbortCode::UNKNOWN_COMMAND);
        }
        self.phase = Phase::Send;
        Ok(())
    }

    /// The next segment.
    #[inline]
    pub(super) fn segment<D: Device>(&mut self, device: &mut D, buffer: &mut [u8]) -> Result<[u8; 8], AbortCode> {
        let piece = self.outgoing.next(device, buffer)?;
        self.sequence += 1;
        if piece.is_last || self.sequence == self.block_size {
            self.phase = Phase::Acknowledge;
            self.unused = 7 - piece.length;
        }
        Ok(response::block_segment(piece.is_last, self.sequence, piece.bits))
    }

    /// Takes `A2`: goes on behind what was taken. When that is all, gives the end.
    ///
    /// A client that has missed a segment may say so before the block is over: that ends the block.
    pub(super) fn acknowledge(&mut self, sequence: u8, block_size: u8) -> Result<Option<[u8; 8]>, AbortCode> {
        if !matches!(self.phase, Phase::Send | Phase::Acknowledge) {
            return Err(AbortCode::UNKNOWN_COMMAND);
        }
        if sequence > self.sequence {
            return Err(AbortCode::INVALID_SEQUENCE_NUMBER);
        }
        let is_whole = sequence == self.sequence && sequence != 0;
        if is_whole && self.outgoing.sent() == self.outgoing.size() {
            return Ok(Some(self.end()));
        }
        check_block_size(block_size)?;
        self.confirmed += usize::from(sequence) * 7;
        self.outgoing.go_back(self.confirmed);
        self.phase = Phase::Send;
        self.block_size = block_size;
        self.sequence = 0;
        Ok(None)
    }

    fn end(&mut self) -> [u8; 8] {
        self.phase = Phase::End;
        let (unused, crc) = (self.unused, self.outgoing.crc());
        Response::BlockUploadEnd { unused, crc }.emit()
    }

    /// Takes `A1`.
    pub(super) fn finish(&self) -> Result<(), AbortCode> {
        match self.phase {
            Phase::End => Ok(()),
            _ => Err(AbortCode::UNKNOWN_COMMAND),
        }
    }
}
