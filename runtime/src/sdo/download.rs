//! Download: the client writes.
//!
//! ```text
//! expedited   2F 17 10 00 05 ‥ ‥ ‥ ─▶        ◀─ 60 17 10 00 00 00 00 00
//!             23 four bytes, 27 three, 2B two, 2F one, 22 as many as the object has
//! segmented   21 09 20 00 0A 00 00 00 ─▶     ◀─ 60 09 20 00 00 00 00 00     21: ten bytes will follow; 20: some will
//!             00 61 62 63 64 65 66 67 ─▶     ◀─ 20 00 00 00 00 00 00 00
//!             19 68 69 6A ‥ ‥ ‥ ‥ ─▶         ◀─ 30 00 00 00 00 00 00 00     bit 4 toggles, bit 0: the last
//! ```

use crate::{
    od::{self, Device, Entry, Services},
    wire::sdo::{Expedited, Response, Segment},
    AbortCode, Address,
};

/// Segments are coming in for `entry`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Download {
    entry: Entry,
    /// The most bytes that are taken.
    room: usize,
    /// How many the client promised.
    promised: Option<usize>,
    received: usize,
    /// The toggle bit of the next segment.
    toggle: bool,
}

/// A value that came with the request itself.
#[inline]
pub(super) fn expedited<D: Device>(
    device: &mut D,
    services: &mut impl Services,
    address: Address,
    value: Expedited,
) -> [u8; 8] {
    match write(device, services, address, value) {
        Ok(()) => Response::DownloadInitiate { address }.emit(),
        Err(code) => Response::Abort { address, code }.emit(),
    }
}

#[inline]
fn write<D: Device>(
    device: &mut D,
    services: &mut impl Services,
    address: Address,
    value: Expedited,
) -> Result<(), AbortCode> {
    let entry = od::writable(device, address)?;
    let expected = entry.data_type.length();
    match value.length.map(usize::from) {
        Some(length) if length == expected => {}
        // Without a size the client trusts the object's own.
        None if (1..=4).contains(&expected) => {}
        None if expected > 4 => return Err(AbortCode::LENGTH_MISMATCH),
        length => {
            let length = length.unwrap_or_else(|| od::capacity(device, entry).min(4));
            let bytes = value.bits.to_le_bytes();
            return od::store(device, services, entry, bytes.get(..length).unwrap_or(&bytes));
        }
    }
    od::store_number(device, services, entry, u64::from(value.bits))
}

impl Download {
    /// Takes `20` or `21`: segments will follow, into a buffer of `buffer` bytes.
    pub(super) fn new<D: Device>(
        device: &D,
        buffer: usize,
        address: Address,
        size: Option<u32>,
    ) -> Result<Self, AbortCode> {
        let entry = od::writable(device, address)?;
        let promised = size.map(|size| usize::try_from(size).unwrap_or(usize::MAX));
        if let Some(promised) = promised {
            od::check_length(device, entry, promised)?;
        }
        if promised.is_some_and(|promised| promised > buffer) {
            return Err(AbortCode::OUT_OF_MEMORY);
        }
        Ok(Self {
            entry,
            room: od::capacity(device, entry).min(buffer),
            promised,
            received: 0,
            toggle: false,
        })
    }

    pub(super) const fn address(&self) -> Address {
        self.entry.address()
    }

    /// State `Download`: takes `0x` or `1x`; after the last segment the value is stored.
    pub(super) fn segment<D: Device>(
        &mut self,
        device: &mut D,
        services: &mut impl Services,
        buffer: &mut [u8],
        segment: Segment,
    ) -> Result<(), AbortCode> {
        if segment.toggle != self.toggle {
            return Err(AbortCode::TOGGLE_NOT_ALTERNATED);
        }
        self.take(buffer, segment)?;
        if segment.last {
            self.store(device, services, buffer)?;
        }
        Ok(())
    }

    /// Puts the segment's bytes behind those before them.
    fn take(&mut self, buffer: &mut [u8], segment: Segment) -> Result<(), AbortCode> {
        let expected = self.promised.unwrap_or(self.room);
        let mut bytes = segment.bytes();
        if segment.last && bytes.len() == 7 {
            // "n = 0 if no segment size is indicated" (CiA 301, 7.2.4.3.4): then what is expected ends the value.
            bytes = bytes.get(..expected.saturating_sub(self.received)).unwrap_or(bytes);
        }
        let end = self.received + bytes.len();
        if end > expected {
            return Err(AbortCode::TOO_LONG);
        }
        let room = buffer.get_mut(self.received..end).ok_or(AbortCode::OUT_OF_MEMORY)?;
        room.iter_mut().zip(bytes).for_each(|(to, from)| *to = *from);
        self.received = end;
        self.toggle = !self.toggle;
        Ok(())
    }

    fn store<D: Device>(&self, device: &mut D, services: &mut impl Services, buffer: &[u8]) -> Result<(), AbortCode> {
        if self.promised.is_some_and(|promised| self.received < promised) {
            return Err(AbortCode::TOO_SHORT);
        }
        let data = buffer.get(..self.received).ok_or(AbortCode::OUT_OF_MEMORY)?;
        od::store(device, services, self.entry, data)
    }
}
