//! Upload: the client reads.
//!
//! ```text
//! expedited   40 04 60 00 00 00 00 00 ─▶     ◀─ 43 04 60 00 44 33 22 11     43 four bytes, 47 three, 4B two, 4F one
//! segmented   40 08 10 00 00 00 00 00 ─▶     ◀─ 41 08 10 00 0A 00 00 00     ten bytes will follow
//!             60 00 00 00 00 00 00 00 ─▶     ◀─ 00 61 62 63 64 65 66 67
//!             70 00 00 00 00 00 00 00 ─▶     ◀─ 19 68 69 6A 00 00 00 00     bit 4 toggles, bit 0: the last
//! ```

use super::outgoing::{Outgoing, Piece};
use crate::{
    od::{self, DataType, Device, Entry, Value},
    wire::sdo::Expedited,
    AbortCode, Address,
};

/// Segments are asked for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Upload {
    pub(super) outgoing: Outgoing,
    /// The toggle bit of the next request.
    toggle: bool,
}

/// How an upload begins.
#[derive(Clone, Copy)]
pub(super) enum Begun {
    /// The value fits into the response, and that is all.
    Complete(Expedited),
    /// The value may be longer.
    Long(Entry),
}

/// Takes `40`: gives the value itself if it is a number of up to four bytes.
#[inline]
pub(super) fn initiate<D: Device>(device: &mut D, address: Address) -> Result<Begun, AbortCode> {
    let entry = od::readable(device, address)?;
    if matches!(entry.data_type.length(), 1..=4) {
        if let Value::Number { bits, data_type } = od::load(device, entry)? {
            return Ok(Begun::Complete(expedited(bits, data_type)));
        }
    }
    Ok(Begun::Long(entry))
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

impl Upload {
    /// Begins with the first segment.
    pub(super) const fn begin(outgoing: Outgoing) -> Self {
        Self {
            outgoing,
            toggle: false,
        }
    }

    /// State `Upload`: takes `60` or `70`, gives the next seven bytes.
    #[inline]
    pub(super) fn segment<D: Device>(
        &mut self,
        device: &mut D,
        buffer: &mut [u8],
        toggle: bool,
    ) -> Result<Piece, AbortCode> {
        if toggle != self.toggle {
            return Err(AbortCode::TOGGLE_NOT_ALTERNATED);
        }
        self.toggle = !toggle;
        self.outgoing.next(device, buffer)
    }
}
