//! What a server says.

use super::{block, join, split, Expedited, Segment};
use crate::{AbortCode, Address};

/// From server to client.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Response {
    /// `000tnnnc`: some more bytes.
    UploadSegment(Segment),
    /// `001t----`: the segment was taken.
    DownloadSegment {
        /// As in the request.
        toggle: bool,
    },
    /// `010-nn1s`: the value itself.
    UploadExpedited {
        /// The value's place.
        address: Address,
        /// The value.
        value: Expedited,
    },
    /// `010---0s`: the value comes in segments.
    UploadInitiate {
        /// The value's place.
        address: Address,
        /// How many bytes there will be, if the server says so.
        size: Option<u32>,
    },
    /// `011-----`: the value was written, or segments may be sent.
    DownloadInitiate {
        /// The value's place.
        address: Address,
    },
    /// `100-----`: the server refuses.
    Abort {
        /// The value's place.
        address: Address,
        /// Why.
        code: AbortCode,
    },
    /// `101--c00`: blocks may be sent.
    BlockDownloadInitiate {
        /// The value's place.
        address: Address,
        /// Whether the server checks a CRC.
        crc: bool,
        /// How many segments may come in the first block, 1 to 127.
        block_size: u8,
    },
    /// `101---10`: the block was taken.
    BlockDownloadAcknowledge {
        /// The sequence number of the last segment that came behind all those before it; 0 for none.
        sequence: u8,
        /// How many segments may come in the next block, 1 to 127.
        block_size: u8,
    },
    /// `101---01`: the value was written.
    BlockDownloadEnd,
    /// `110--cs0`: the value comes in blocks.
    BlockUploadInitiate {
        /// The value's place.
        address: Address,
        /// Whether the server gives a CRC.
        crc: bool,
        /// How many bytes there will be, if the server says so.
        size: Option<u32>,
    },
    /// `110nnn-1`: that was all.
    BlockUploadEnd {
        /// How many bytes of the last segment do not count, 0 to 7.
        unused: u8,
        /// The CRC of all bytes that count, if both sides have said that they know it; else 0.
        crc: u16,
    },
    /// A command that has no meaning here.
    Unknown {
        /// What stands where the multiplexer would be.
        address: Address,
    },
}

impl Response {
    /// What eight bytes from a server say.
    #[must_use]
    pub fn parse(bytes: [u8; 8]) -> Self {
        let [command, ..] = bytes;
        let (address, word) = split(bytes);
        match command >> 5 {
            0 => Self::UploadSegment(Segment::parse(bytes)),
            1 => Self::DownloadSegment {
                toggle: command & 0x10 != 0,
            },
            2 if command & 0x02 != 0 => Self::UploadExpedited {
                address,
                value: Expedited {
                    bits: word,
                    length: (command & 0x01 != 0).then_some(4 - (command >> 2 & 0x03)),
                },
            },
            2 => Self::UploadInitiate {
                address,
                size: (command & 0x01 != 0).then_some(word),
            },
            3 => Self::DownloadInitiate { address },
            4 => Self::Abort {
                address,
                code: AbortCode(word),
            },
            5 => Self::parse_block_download(bytes),
            6 if command & 0x01 == 0 => Self::BlockUploadInitiate {
                address,
                crc: command & 0x04 != 0,
                size: (command & 0x02 != 0).then_some(word),
            },
            6 => Self::BlockUploadEnd {
                unused: command >> 2 & 0x07,
                crc: address.index,
            },
            _ => Self::Unknown { address },
        }
    }

    fn parse_block_download(bytes: [u8; 8]) -> Self {
        let [command, first, second, _, block_size, ..] = bytes;
        let (address, _) = split(bytes);
        match command & 0x03 {
            0 => Self::BlockDownloadInitiate {
                address,
                crc: command & 0x04 != 0,
                block_size,
            },
            1 => Self::BlockDownloadEnd,
            2 => Self::BlockDownloadAcknowledge {
                sequence: first,
                block_size: second,
            },
            _ => Self::Unknown { address },
        }
    }

    /// The eight bytes; of [`Response::Unknown`] as of [`Request::Unknown`](super::Request::Unknown).
    #[allow(clippy::inline_always)] // Who calls it knows the kind: of the match a few instructions are left.
    #[inline(always)]
    #[must_use]
    pub fn emit(self) -> [u8; 8] {
        match self {
            Self::UploadSegment(segment) => segment.emit(0x00),
            Self::DownloadSegment { toggle } => [0x20 | u8::from(toggle) << 4, 0, 0, 0, 0, 0, 0, 0],
            Self::UploadExpedited { address, value } => join(0x40 | value.command(), address, value.bits),
            Self::UploadInitiate { address, size } => join(0x40 | u8::from(size.is_some()), address, size.unwrap_or(0)),
            Self::DownloadInitiate { address } => join(0x60, address, 0),
            Self::Abort { address, code } => join(0x80, address, code.0),
            Self::BlockDownloadInitiate {
                address,
                crc,
                block_size,
            } => join(0xA0 | u8::from(crc) << 2, address, u32::from(block_size)),
            Self::BlockDownloadAcknowledge { sequence, block_size } => [0xA2, sequence, block_size, 0, 0, 0, 0, 0],
            Self::BlockDownloadEnd => [0xA1, 0, 0, 0, 0, 0, 0, 0],
            Self::BlockUploadInitiate { address, crc, size } => {
                let command = 0xC0 | u8::from(crc) << 2 | u8::from(size.is_some()) << 1;
                join(command, address, size.unwrap_or(0))
            }
            Self::BlockUploadEnd { unused, crc } => block::emit_end(unused, crc),
            Self::Unknown { address } => join(0xE0, address, 0),
        }
    }
}

/// [`Response::UploadSegment`] of the `length` low bytes of `bits`, 0 to 7; the next two are 0.
#[inline]
pub(crate) fn upload_segment(toggle: bool, last: bool, length: u8, bits: u64) -> [u8; 8] {
    let command = u8::from(toggle) << 4 | 7u8.saturating_sub(length) << 1 | u8::from(last);
    (bits << 8 | u64::from(command)).to_le_bytes()
}

/// A [`BlockSegment`](super::BlockSegment) of the seven low bytes of `bits`.
#[inline]
pub(crate) fn block_segment(last: bool, sequence: u8, bits: u64) -> [u8; 8] {
    (bits << 8 | u64::from(u8::from(last) << 7 | sequence)).to_le_bytes()
}
