//! Block download: the client writes, up to 127 segments for each answer.
//!
//! ```text
//! C6 20 10 00 0A 00 00 00 ─▶     ◀─ A4 20 10 00 7F 00 00 00     ten bytes will follow (C4: some will), with a CRC
//! 01 61 62 63 64 65 66 67 ─▶                                    the first segment of the block
//! 82 68 69 6A 00 00 00 00 ─▶     ◀─ A2 02 7F 00 00 00 00 00     bit 7: the last; taken up to the second
//! D1 2A A3 00 00 00 00 00 ─▶     ◀─ A1 00 00 00 00 00 00 00     four bytes of the last do not count; the CRC is A32Ah
//! ```

use super::incoming::Incoming;
use crate::{
    od::{Device, Services},
    wire::sdo::BlockSegment,
    AbortCode, Address,
};

/// Blocks are coming in.
#[derive(Clone, Copy, Debug)]
pub(super) struct BlockDownload {
    pub(super) incoming: Incoming,
    /// Segments of a block.
    block_size: u8,
    /// The number of the last segment of this block that came behind all those before it.
    sequence: u8,
    is_complete: bool,
    has_crc: bool,
}

impl BlockDownload {
    /// Takes `C0` to `C6`: blocks will follow, into a buffer of `buffer` bytes.
    pub(super) fn begin<D: Device>(
        device: &mut D,
        buffer: usize,
        address: Address,
        size: Option<u32>,
        has_crc: bool,
    ) -> Result<Self, AbortCode> {
        let incoming = Incoming::begin(device, buffer, address, size)?;
        Ok(Self {
            incoming,
            block_size: incoming.block_size::<D>(buffer),
            sequence: 0,
            is_complete: false,
            has_crc,
        })
    }

    /// How many segments a block may have.
    pub(super) const fn block_size(&self) -> u8 {
        self.block_size
    }

    /// Whether all segments are there: what comes is no segment any more.
    #[inline]
    pub(super) const fn is_complete(&self) -> bool {
        self.is_complete
    }

    /// Takes a segment; gives the number to acknowledge after the last one of a block. What comes behind a lost one is
    /// dropped, and the client sends it again.
    #[inline]
    pub(super) fn segment<D: Device>(
        &mut self,
        device: &mut D,
        buffer: &mut [u8],
        segment: BlockSegment,
    ) -> Result<Option<u8>, AbortCode> {
        if segment.sequence == 0 || segment.sequence > self.block_size {
            return Err(AbortCode::INVALID_SEQUENCE_NUMBER);
        }
        if segment.sequence == self.sequence + 1 {
            if self.incoming.missing() == 0 && self.sequence != 0 {
                return Err(AbortCode::TOO_LONG);
            }
            self.incoming.take(device, buffer, segment.data, 7)?;
            self.sequence = segment.sequence;
            self.is_complete = segment.last;
        }
        if segment.last || segment.sequence == self.block_size {
            return self.end_block(device, buffer).map(Some);
        }
        Ok(None)
    }

    /// The client awaits an answer now, so the application may take its time.
    fn end_block<D: Device>(&mut self, device: &mut D, buffer: &[u8]) -> Result<u8, AbortCode> {
        if !self.is_complete {
            self.incoming.make_room(device, buffer)?;
        }
        let sequence = self.sequence;
        self.sequence = 0;
        Ok(sequence)
    }

    /// Takes `C1` to `DD`: stores the value.
    pub(super) fn end<D: Device>(
        &self,
        device: &mut D,
        services: &mut impl Services,
        buffer: &[u8],
        unused: u8,
        crc: u16,
    ) -> Result<(), AbortCode> {
        let sum = self.has_crc.then_some(crc);
        self.incoming.finish(device, services, buffer, unused, sum)
    }
}
