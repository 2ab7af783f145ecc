//! A value on its way out: a snapshot in the server's buffer, cut into segments.
//!
//! A constant is cut where it stands. Of one that the application gives in parts, the buffer holds a piece at a time.

use super::is_in_parts;
use crate::{
    od::{self, Access, Device, Entry, Value},
    wire::sdo::{Expedited, Segment},
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
}

impl Outgoing {
    /// Begins with the value of `entry`, which [`od::readable`] gave.
    #[inline(never)]
    pub(super) fn begin<D: Device>(device: &mut D, buffer: &mut [u8], entry: Entry) -> Result<Self, AbortCode> {
        let size = if is_in_parts::<D>(entry) {
            device.read_part(entry.address(), 0, buffer)?
        } else {
            snapshot::<D>(buffer, entry, od::load(device, entry)?)?
        };
        Ok(Self {
            entry,
            size,
            sent: 0,
            before: 0,
        })
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
    pub(super) fn expedited<D: Device>(&mut self, device: &mut D, buffer: &mut [u8]) -> Option<Expedited> {
        let length = u8::try_from(self.size).ok().filter(|size| matches!(size, 1..=4))?;
        let [d0, d1, d2, d3, ..] = self.next(device, buffer).ok()?.data;
        Some(Expedited {
            bits: u32::from_le_bytes([d0, d1, d2, d3]),
            length: Some(length),
        })
    }

    /// The next seven bytes, or all that is left. Its toggle bit is for the caller to set.
    #[inline]
    #[allow(clippy::cast_possible_truncation)] // The length is 0 to 7.
    pub(super) fn next<D: Device>(&mut self, device: &mut D, buffer: &mut [u8]) -> Result<Segment, AbortCode> {
        if is_in_parts::<D>(self.entry) {
            self.fetch(device, buffer)?;
        }
        let value = if stands_in_flash::<D>(self.entry) {
            od::load(device, self.entry)?.to_bytes()
        } else {
            buffer
        };
        let left = self.size - self.sent;
        let length = left.min(7);
        let from = self.sent - self.before;
        let rest = value.get(from..).ok_or(AbortCode::INTERNAL_INCOMPATIBILITY)?;
        let mut data = [0; 7];
        match rest.first_chunk() {
            Some(full) if length == 7 => data = *full,
            _ => data
                .iter_mut()
                .zip(rest.iter().take(length))
                .for_each(|(to, from)| *to = *from),
        }
        self.sent += length;
        Ok(Segment {
            toggle: false,
            last: left <= 7,
            length: length as u8,
            data,
        })
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
        Ok(())
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
