//! Download: the client writes.
//!
//! ```text
//! expedited   2F 17 10 00 05 ‥ ‥ ‥ ─▶        ◀─ 60 17 10 00 00 00 00 00
//!             23 four bytes, 27 three, 2B two, 2F one, 22 as many as the object has
//! segmented   21 09 20 00 0A 00 00 00 ─▶     ◀─ 60 09 20 00 00 00 00 00     21: ten bytes will follow; 20: some will
//!             00 61 62 63 64 65 66 67 ─▶     ◀─ 20 00 00 00 00 00 00 00
//!             19 68 69 6A ‥ ‥ ‥ ‥ ─▶         ◀─ 30 00 00 00 00 00 00 00     bit 4 toggles, bit 0: the last
//! ```

use super::{incoming::Incoming, is_in_parts};
use crate::{
    od::{self, Device, Services},
    wire::sdo::{Expedited, Response, Segment},
    AbortCode, Address,
};

/// Segments are coming in.
#[derive(Clone, Copy, Debug)]
pub(super) struct Download {
    pub(super) incoming: Incoming,
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
            let bytes = value.bits.to_le_bytes();
            if is_in_parts::<D>(entry) {
                return write_whole(device, services, address, bytes, length.unwrap_or(4));
            }
            let length = length.unwrap_or_else(|| od::capacity(device, entry).min(4));
            return od::store(device, services, entry, bytes.get(..length).unwrap_or(&bytes));
        }
    }
    od::store_number(device, services, entry, u64::from(value.bits))
}

/// A short value that the application takes in parts: one part.
#[cold]
#[inline(never)]
fn write_whole<D: Device>(
    device: &mut D,
    services: &mut impl Services,
    address: Address,
    bytes: [u8; 4],
    length: usize,
) -> Result<(), AbortCode> {
    let mut buffer = [0; 8];
    let [d0, d1, d2, d3] = bytes;
    let mut incoming = Incoming::begin(device, buffer.len(), address, u32::try_from(length).ok())?;
    incoming.take(device, &mut buffer, [d0, d1, d2, d3, 0, 0, 0], length)?;
    incoming.finish(device, services, &buffer, 0, None)
}

impl Download {
    /// Takes `20` or `21`: segments will follow, into a buffer of `buffer` bytes.
    pub(super) fn begin<D: Device>(
        device: &mut D,
        buffer: usize,
        address: Address,
        size: Option<u32>,
    ) -> Result<Self, AbortCode> {
        let incoming = Incoming::begin(device, buffer, address, size)?;
        Ok(Self {
            incoming,
            toggle: false,
        })
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
        let missing = self.incoming.missing();
        let mut length = usize::from(segment.length);
        if segment.last && length == 7 {
            // "n = 0 if no segment size is indicated" (CiA 301, 7.2.4.3.4): then what is expected ends the value.
            length = missing.min(7);
        }
        if length > missing {
            return Err(AbortCode::TOO_LONG);
        }
        self.incoming.take(device, buffer, segment.data, length)?;
        self.toggle = !self.toggle;
        if segment.last {
            self.incoming.finish(device, services, buffer, 0, None)?;
        }
        Ok(())
    }
}
