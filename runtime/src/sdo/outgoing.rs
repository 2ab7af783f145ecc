//! A value on its way out: a snapshot in the server's buffer, cut into segments.
//!
//! A constant is cut where it stands. Of one that the application gives in parts, the buffer holds a piece at a time.

use super::{crc, is_in_parts};
use crate::{
    od::{self, Access, Device, Entry, Value},
    wire::sdo::Expedited,
    AbortCode, Address,
};

/// What has gone of a value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Outgoing {
    entry: Entry,
    size: usize,
    sent: usize,
    /// Bytes of the value before those in the buffer.
    before: usize,
    /// The CRC of the first `summed` bytes, if the client wants one.
    crc: u16,
    summed: usize,
    has_crc: bool,
    /// Whether all of it is in the buffer.
    is_snapshot: bool,
}

/// Up to seven bytes of it.
#[derive(Clone, Copy)]
pub(super) struct Piece {
    /// The bytes, the first the lowest; 0 beyond the length, but for the eighth.
    pub(super) bits: u64,
    /// How many there are.
    pub(super) length: u8,
    /// Whether nothing is left.
    pub(super) is_last: bool,
}

impl Outgoing {
    /// Begins with the value of `entry`, which [`od::readable`] gave.
    #[inline(never)]
    pub(super) fn begin<D: Device>(
        device: &mut D,
        buffer: &mut [u8],
        entry: Entry,
        has_crc: bool,
    ) -> Result<Self, AbortCode> {
        let size = if is_in_parts::<D>(entry) {
            device.read_part(entry.address(), 0, buffer)?
        } else {
            snapshot::<D>(buffer, entry, od::load(device, entry)?)?
        };
        let mut outgoing = Self {
            entry,
            size,
            sent: 0,
            before: 0,
            crc: 0,
            summed: 0,
            has_crc,
            is_snapshot: !is_in_parts::<D>(entry) && !stands_in_flash::<D>(entry),
        };
        if has_crc {
            outgoing.sum(device, buffer)?;
        }
        Ok(outgoing)
    }

    /// The CRC of all that the client has got; 0 if it wants none.
    pub(super) const fn crc(&self) -> u16 {
        self.crc
    }

    pub(super) const fn address(&self) -> Address {
        self.entry.address()
    }

    /// How many bytes the value has.
    pub(super) const fn size(&self) -> usize {
        self.size
    }

    /// The same for a response; a number that does not fit into it is not said.
    pub(super) fn announced(&self) -> Option<u32> {
        u32::try_from(self.size).ok()
    }

    /// How many bytes have gone.
    pub(super) const fn sent(&self) -> usize {
        self.sent
    }

    /// Goes on from the byte number `sent` instead.
    pub(super) fn go_back(&mut self, sent: usize) {
        self.sent = sent;
    }

    /// The value itself, if it has one to four bytes.
    #[allow(clippy::cast_possible_truncation)] // The higher ones are 0.
    pub(super) fn expedited<D: Device>(&mut self, device: &mut D, buffer: &mut [u8]) -> Option<Expedited> {
        if !matches!(self.size, 1..=4) {
            return None;
        }
        let piece = self.cut(device, buffer).ok()?;
        Some(Expedited {
            bits: piece.bits as u32,
            length: Some(piece.length),
        })
    }

    /// The next seven bytes, or all that is left.
    #[inline]
    pub(super) fn next<D: Device>(&mut self, device: &mut D, buffer: &mut [u8]) -> Result<Piece, AbortCode> {
        if self.is_snapshot && self.size - self.sent > 7 {
            if let Some(bytes) = buffer.get(self.sent..).and_then(<[u8]>::first_chunk) {
                self.sent += 7;
                return Ok(Piece {
                    bits: u64::from_le_bytes(*bytes),
                    length: 7,
                    is_last: false,
                });
            }
        }
        self.cut(device, buffer)
    }

    /// The same of any value, its end too.
    #[inline(never)]
    fn cut<D: Device>(&mut self, device: &mut D, buffer: &mut [u8]) -> Result<Piece, AbortCode> {
        if is_in_parts::<D>(self.entry) {
            self.fetch(device, buffer)?;
        }
        let left = self.size - self.sent;
        let value = self.value(device, buffer)?;
        let rest = value.get(self.sent - self.before..).unwrap_or_default();
        let piece = first(rest, left);
        self.sent += usize::from(piece.length);
        Ok(piece)
    }

    /// The bytes that the next ones are cut from.
    #[inline(never)]
    fn value<'a, D: Device>(&self, device: &'a D, buffer: &'a [u8]) -> Result<&'a [u8], AbortCode> {
        if stands_in_flash::<D>(self.entry) {
            return Ok(od::load(device, self.entry)?.to_bytes());
        }
        Ok(buffer)
    }

    /// Adds what the buffer holds to the CRC, but for what is in it already.
    fn sum<D: Device>(&mut self, device: &D, buffer: &[u8]) -> Result<(), AbortCode> {
        let value = self.value(device, buffer)?;
        let end = value.len().min(self.size - self.before);
        let new = value.get(self.summed - self.before..end).unwrap_or_default();
        self.crc = crc(self.crc, new);
        self.summed += new.len();
        Ok(())
    }

    /// Has the application fill the buffer anew, if it does not hold the next seven bytes.
    #[cold]
    #[inline(never)]
    fn fetch<D: Device>(&mut self, device: &mut D, buffer: &mut [u8]) -> Result<(), AbortCode> {
        let end = self.size.min(self.sent + 7);
        if self.before <= self.sent && end <= self.before + buffer.len() {
            return Ok(());
        }
        if device.read_part(self.address(), self.sent, buffer)? != self.size {
            // What the client has got already is of another value.
            return Err(AbortCode::DEVICE_STATE);
        }
        self.before = self.sent;
        if self.has_crc {
            self.sum(device, buffer)?;
        }
        Ok(())
    }
}

/// The first seven bytes of what is left, or all of it.
#[allow(clippy::cast_possible_truncation)] // The length is 0 to 7.
fn first(rest: &[u8], left: usize) -> Piece {
    let length = left.min(7);
    let mut bytes = [0; 8];
    bytes
        .iter_mut()
        .zip(rest.iter().take(length))
        .for_each(|(to, from)| *to = *from);
    Piece {
        bits: u64::from_le_bytes(bytes),
        length: length as u8,
        is_last: left <= 7,
    }
}

/// Copies the value into the buffer; gives its length.
fn snapshot<D: Device>(buffer: &mut [u8], entry: Entry, value: Value<'_>) -> Result<usize, AbortCode> {
    let number;
    let bytes = match value {
        Value::Bytes(bytes) => bytes,
        Value::Number { bits, data_type } => {
            number = bits.to_le_bytes();
            number.get(..data_type.length()).unwrap_or(&number)
        }
    };
    if !stands_in_flash::<D>(entry) {
        let room = buffer.get_mut(..bytes.len()).ok_or(AbortCode::OUT_OF_MEMORY)?;
        room.copy_from_slice(bytes);
    }
    Ok(bytes.len())
}

/// Whether it is a constant string: it cannot change under way, so no snapshot is taken.
fn stands_in_flash<D: Device>(entry: Entry) -> bool {
    entry.access.has(Access::CONSTANT) && entry.data_type.length() == 0 && !is_in_parts::<D>(entry)
}
