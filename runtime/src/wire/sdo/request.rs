//! What a client says.

use super::{block, join, split, Expedited, Segment};
use crate::{AbortCode, Address};

/// From client to server.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Request {
    /// `001-nn1s`: write these bytes to `address`.
    DownloadExpedited {
        /// The value's place.
        address: Address,
        /// The value.
        value: Expedited,
    },
    /// `001---0s`: segments for `address` will follow.
    DownloadInitiate {
        /// The value's place.
        address: Address,
        /// How many bytes there will be, if the client says so.
        size: Option<u32>,
    },
    /// `000tnnnc`: some more bytes.
    DownloadSegment(Segment),
    /// `010-----`: read `address`.
    UploadInitiate {
        /// The value's place.
        address: Address,
    },
    /// `011t----`: send some more bytes.
    UploadSegment {
        /// Alternates from request to request, beginning with `false`.
        toggle: bool,
    },
    /// `100-----`: the client gives the transfer up.
    Abort {
        /// The value's place.
        address: Address,
        /// Why.
        code: AbortCode,
    },
    /// `101--c00`: read `address` in blocks.
    BlockUploadInitiate {
        /// The value's place.
        address: Address,
        /// Whether the client checks a CRC.
        crc: bool,
        /// How many segments may come in the first block, 1 to 127.
        block_size: u8,
        /// Up to how many bytes the server may send by another protocol; 0 for none.
        threshold: u8,
    },
    /// `101---11`: send the first block.
    BlockUploadStart,
    /// `101---10`: the block was taken.
    BlockUploadAcknowledge {
        /// The sequence number of the last segment that came behind all those before it; 0 for none.
        sequence: u8,
        /// How many segments may come in the next block, 1 to 127.
        block_size: u8,
    },
    /// `101---01`: the value was taken.
    BlockUploadEnd,
    /// `110--cs0`: blocks for `address` will follow.
    BlockDownloadInitiate {
        /// The value's place.
        address: Address,
        /// Whether the client gives a CRC.
        crc: bool,
        /// How many bytes there will be, if the client says so.
        size: Option<u32>,
    },
    /// `110nnn-1`: that was all.
    BlockDownloadEnd {
        /// How many bytes of the last segment do not count, 0 to 7.
        unused: u8,
        /// The CRC of all bytes that count, if both sides have said that they know it.
        crc: u16,
    },
    /// A command that has no meaning here.
    Unknown {
        /// What stands where the multiplexer would be.
        address: Address,
    },
}

impl Request {
    /// What eight bytes from a client say.
    #[allow(clippy::inline_always)] // The server only has one place that asks.
    #[inline(always)]
    #[must_use]
    pub fn parse(bytes: [u8; 8]) -> Self {
        let [command, ..] = bytes;
        let (address, word) = split(bytes);
        match command >> 5 {
            0 => Self::DownloadSegment(Segment::parse(bytes)),
            1 if command & 0x02 != 0 => Self::DownloadExpedited {
                address,
                value: Expedited {
                    bits: word,
                    length: (command & 0x01 != 0).then_some(4 - (command >> 2 & 0x03)),
                },
            },
            1 => Self::DownloadInitiate {
                address,
                size: (command & 0x01 != 0).then_some(word),
            },
            2 => Self::UploadInitiate { address },
            3 => Self::UploadSegment {
                toggle: command & 0x10 != 0,
            },
            4 => Self::Abort {
                address,
                code: AbortCode(word),
            },
            5 => Self::parse_block_upload(bytes),
            6 if command & 0x01 == 0 => Self::BlockDownloadInitiate {
                address,
                crc: command & 0x04 != 0,
                size: (command & 0x02 != 0).then_some(word),
            },
            6 => Self::BlockDownloadEnd {
                unused: command >> 2 & 0x07,
                crc: address.index,
            },
            _ => Self::Unknown { address },
        }
    }

    fn parse_block_upload(bytes: [u8; 8]) -> Self {
        let [command, first, second, _, block_size, threshold, ..] = bytes;
        let (address, _) = split(bytes);
        match command & 0x03 {
            0 => Self::BlockUploadInitiate {
                address,
                crc: command & 0x04 != 0,
                block_size,
                threshold,
            },
            1 => Self::BlockUploadEnd,
            2 => Self::BlockUploadAcknowledge {
                sequence: first,
                block_size: second,
            },
            _ => Self::BlockUploadStart,
        }
    }

    /// The eight bytes; of [`Request::Unknown`] those with the command specifier 7, which no standard has given a meaning.
    #[must_use]
    pub fn emit(self) -> [u8; 8] {
        match self {
            Self::DownloadExpedited { address, value } => join(0x20 | value.command(), address, value.bits),
            Self::DownloadInitiate { address, size } => {
                join(0x20 | u8::from(size.is_some()), address, size.unwrap_or(0))
            }
            Self::DownloadSegment(segment) => segment.emit(0x00),
            Self::UploadInitiate { address } => join(0x40, address, 0),
            Self::UploadSegment { toggle } => [0x60 | u8::from(toggle) << 4, 0, 0, 0, 0, 0, 0, 0],
            Self::Abort { address, code } => join(0x80, address, code.0),
            Self::BlockUploadInitiate {
                address,
                crc,
                block_size,
                threshold,
            } => {
                let word = u32::from_le_bytes([block_size, threshold, 0, 0]);
                join(0xA0 | u8::from(crc) << 2, address, word)
            }
            Self::BlockUploadStart => [0xA3, 0, 0, 0, 0, 0, 0, 0],
            Self::BlockUploadAcknowledge { sequence, block_size } => [0xA2, sequence, block_size, 0, 0, 0, 0, 0],
            Self::BlockUploadEnd => [0xA1, 0, 0, 0, 0, 0, 0, 0],
            Self::BlockDownloadInitiate { address, crc, size } => {
                let command = 0xC0 | u8::from(crc) << 2 | u8::from(size.is_some()) << 1;
                join(command, address, size.unwrap_or(0))
            }
            Self::BlockDownloadEnd { unused, crc } => block::emit_end(unused, crc),
            Self::Unknown { address } => join(0xE0, address, 0),
        }
    }
}
