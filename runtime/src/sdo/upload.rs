//! Upload: the client reads.
//!
//! ```text
//! expedited   40 04 60 00 00 00 00 00 ─▶     ◀─ 43 04 60 00 44 33 22 11     43 four bytes, 47 three, 4B two, 4F one
//! segmented   40 08 10 00 00 00 00 00 ─▶     ◀─ 41 08 10 00 0A 00 00 00     ten bytes will follow
//!             60 00 00 00 00 00 00 00 ─▶     ◀─ 00 61 62 63 64 65 66 67
//!             70 00 00 00 00 00 00 00 ─▶     ◀─ 19 68 69 6A 00 00 00 00     bit 4 toggles, bit 0: the last
//! ```

use super::server::{refuse, State, Step};
use crate::{
    od::{self, Access, DataType, Device, Entry, Value},
    wire::sdo::{Expedited, Response, Segment},
    AbortCode, Address,
};

/// Segments of `entry` are asked for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Upload {
    entry: Entry,
    size: usize,
    sent: usize,
    /// The toggle bit of the next request.
    toggle: bool,
}

/// State `Idle`: takes `40`, answers with the value itself, or with its length and goes on in state `Upload`.
#[inline]
pub(super) fn initiate<D: Device>(device: &mut D, buffer: &mut [u8], address: Address) -> Step {
    match begin(device, buffer, address) {
        Ok(step) => step,
        Err(code) => refuse(address, code),
    }
}

#[inline]
fn begin<D: Device>(device: &mut D, buffer: &mut [u8], address: Address) -> Result<Step, AbortCode> {
    let entry = od::readable(device, address)?;
    match od::load(device, entry)? {
        Value::Number { bits, data_type } if data_type.length() <= 4 => Ok(expedited(address, bits, data_type)),
        value => segmented(entry, buffer, value),
    }
}

/// The value fits into the response.
#[inline]
#[allow(clippy::cast_possible_truncation)] // The length is 1 to 4.
fn expedited(address: Address, bits: u64, data_type: DataType) -> Step {
    let length = data_type.length();
    let value = Expedited {
        bits: bits as u32 & (u32::MAX >> ((32 - 8 * length) & 31)),
        length: Some(length as u8),
    };
    (State::Idle, Response::UploadExpedited { address, value })
}

/// The value is long, or has a length of its own.
fn segmented(entry: Entry, buffer: &mut [u8], value: Value<'_>) -> Result<Step, AbortCode> {
    let address = entry.address();
    let number;
    let bytes = match value {
        Value::Bytes(bytes) => bytes,
        Value::Number { bits, data_type } => {
            number = bits.to_le_bytes();
            number.get(..data_type.length()).unwrap_or(&number)
        }
    };
    if let Some(short) = short(bytes) {
        return Ok((State::Idle, Response::UploadExpedited { address, value: short }));
    }
    if !stands_in_flash(entry) {
        let room = buffer.get_mut(..bytes.len()).ok_or(AbortCode::OUT_OF_MEMORY)?;
        room.copy_from_slice(bytes);
    }
    let upload = Upload {
        entry,
        size: bytes.len(),
        sent: 0,
        toggle: false,
    };
    let size = u32::try_from(bytes.len()).ok();
    Ok((State::Upload(upload), Response::UploadInitiate { address, size }))
}

/// A string of one to four bytes fits into the response too.
fn short(bytes: &[u8]) -> Option<Expedited> {
    let mut word = [0; 4];
    word.get_mut(..bytes.len())?.copy_from_slice(bytes);
    let length = u8::try_from(bytes.len()).ok().filter(|&length| length != 0)?;
    Some(Expedited {
        bits: u32::from_le_bytes(word),
        length: Some(length),
    })
}

/// Whether it is a constant string: it cannot change under way, so no snapshot is taken.
fn stands_in_flash(entry: Entry) -> bool {
    entry.access.has(Access::CONSTANT) && entry.data_type.length() == 0
}

impl Upload {
    pub(super) const fn address(&self) -> Address {
        self.entry.address()
    }

    /// State `Upload`: takes `60` or `70`, answers with the next seven bytes.
    pub(super) fn segment<D: Device>(mut self, device: &D, buffer: &[u8], toggle: bool) -> Step {
        if toggle != self.toggle {
            return refuse(self.address(), AbortCode::TOGGLE_NOT_ALTERNATED);
        }
        let Some(segment) = self.next(device, buffer) else {
            return refuse(self.address(), AbortCode::INTERNAL_INCOMPATIBILITY);
        };
        let next = if segment.last { State::Idle } else { State::Upload(self) };
        (next, Response::UploadSegment(segment))
    }

    /// Cuts off the next segment.
    fn next<D: Device>(&mut self, device: &D, buffer: &[u8]) -> Option<Segment> {
        let value = if stands_in_flash(self.entry) {
            od::load(device, self.entry).ok()?.to_bytes()
        } else {
            buffer
        };
        let end = self.size.min(self.sent + 7);
        let bytes = value.get(self.sent..end)?;
        let mut data = [0; 7];
        data.get_mut(..bytes.len())?.copy_from_slice(bytes);
        let segment = Segment {
            toggle: self.toggle,
            last: end == self.size,
            length: u8::try_from(bytes.len()).ok()?,
            data,
        };
        self.sent = end;
        self.toggle = !self.toggle;
        Some(segment)
    }
}
