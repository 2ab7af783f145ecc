//! Upload: the client reads.
//!
//! ```text
//! expedited   40 04 60 00 00 00 00 00 ─▶     ◀─ 43 04 60 00 44 33 22 11     43 four bytes, 47 three, 4B two, 4F one
//! segmented   40 08 10 00 00 00 00 00 ─▶     ◀─ 41 08 10 00 0A 00 00 00     ten bytes will follow
//!             60 00 00 00 00 00 00 00 ─▶     ◀─ 00 61 62 63 64 65 66 67
//!             70 00 00 00 00 00 00 00 ─▶     ◀─ 19 68 69 6A 00 00 00 00     bit 4 toggles, bit 0: the last
//! ```

use crate::{
    od::{self, Access, DataType, Device, Entry, Value},
    wire::sdo::{Expedited, Segment},
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

/// How an upload begins.
pub(super) enum Begun {
    /// The value fits into the response, and that is all.
    Complete(Expedited),
    /// The value will be asked for in segments.
    Segmented(Upload),
}

/// Takes `40`: gives the value itself, or a snapshot of it that is uploaded in segments.
#[inline]
pub(super) fn initiate<D: Device>(device: &mut D, buffer: &mut [u8], address: Address) -> Result<Begun, AbortCode> {
    let entry = od::readable(device, address)?;
    match od::load(device, entry)? {
        Value::Number { bits, data_type } if data_type.length() <= 4 => Ok(Begun::Complete(expedited(bits, data_type))),
        value => long(entry, buffer, value),
    }
}

/// A number of one to four bytes.
#[inline]
#[allow(clippy::cast_possible_truncation)] // The length is 1 to 4.
fn expedited(bits: u64, data_type: DataType) -> Expedited {
    let length = data_type.length();
    Expedited {
        bits: bits as u32 & (u32::MAX >> ((32 - 8 * length) & 31)),
        length: Some(length as u8),
    }
}

/// A value that is longer, or has a length of its own.
fn long(entry: Entry, buffer: &mut [u8], value: Value<'_>) -> Result<Begun, AbortCode> {
    let number;
    let bytes = match value {
        Value::Bytes(bytes) => bytes,
        Value::Number { bits, data_type } => {
            number = bits.to_le_bytes();
            number.get(..data_type.length()).unwrap_or(&number)
        }
    };
    if let Some(short) = short(bytes) {
        return Ok(Begun::Complete(short));
    }
    if !stands_in_flash(entry) {
        let room = buffer.get_mut(..bytes.len()).ok_or(AbortCode::OUT_OF_MEMORY)?;
        room.copy_from_slice(bytes);
    }
    Ok(Begun::Segmented(Upload {
        entry,
        size: bytes.len(),
        sent: 0,
        toggle: false,
    }))
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

    /// How many bytes there are; a number that does not fit into the response is not said.
    pub(super) fn size(&self) -> Option<u32> {
        u32::try_from(self.size).ok()
    }

    /// State `Upload`: takes `60` or `70`, gives the next seven bytes.
    pub(super) fn segment<D: Device>(&mut self, device: &D, buffer: &[u8], toggle: bool) -> Result<Segment, AbortCode> {
        if toggle != self.toggle {
            return Err(AbortCode::TOGGLE_NOT_ALTERNATED);
        }
        let value = if stands_in_flash(self.entry) {
            od::load(device, self.entry)?.to_bytes()
        } else {
            buffer
        };
        let rest = value
            .get(self.sent..self.size)
            .ok_or(AbortCode::INTERNAL_INCOMPATIBILITY)?;
        self.toggle = !toggle;
        self.sent += rest.len().min(7);
        Ok(cut(rest, toggle))
    }
}

/// The first seven bytes of what is left, or all of it.
#[allow(clippy::cast_possible_truncation)] // The length is 0 to 7.
fn cut(rest: &[u8], toggle: bool) -> Segment {
    let mut data = [0; 7];
    match rest.first_chunk() {
        Some(full) => data = *full,
        None => data.iter_mut().zip(rest).for_each(|(to, from)| *to = *from),
    }
    Segment {
        toggle,
        last: rest.len() <= 7,
        length: rest.len().min(7) as u8,
        data,
    }
}
