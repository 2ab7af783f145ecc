//! SDO (CiA 301, 7.2.4.3): eight bytes each way, 600h + node-ID from the client, 580h + node-ID from the server.
//!
//! Byte 0 is the command; bytes 1 to 3 are the multiplexer (index, low byte first, then sub-index) in what opens or
//! aborts a transfer. *Download* is the client writing, *upload* is the client reading.

use crate::{AbortCode, Address};

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
    /// A command that has no meaning here.
    Unknown {
        /// What stands where the multiplexer would be.
        address: Address,
    },
}

impl Request {
    /// What eight bytes from a client say.
    #[inline]
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
            _ => Self::Unknown { address },
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
            Self::Unknown { address } => join(0xE0, address, 0),
        }
    }
}

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
            _ => Self::Unknown { address },
        }
    }

    /// The eight bytes; of [`Response::Unknown`] as of [`Request::Unknown`].
    #[inline]
    #[must_use]
    pub fn emit(self) -> [u8; 8] {
        match self {
            Self::UploadSegment(segment) => segment.emit(0x00),
            Self::DownloadSegment { toggle } => [0x20 | u8::from(toggle) << 4, 0, 0, 0, 0, 0, 0, 0],
            Self::UploadExpedited { address, value } => join(0x40 | value.command(), address, value.bits),
            Self::UploadInitiate { address, size } => join(0x40 | u8::from(size.is_some()), address, size.unwrap_or(0)),
            Self::DownloadInitiate { address } => join(0x60, address, 0),
            Self::Abort { address, code } => join(0x80, address, code.0),
            Self::Unknown { address } => join(0xE0, address, 0),
        }
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
