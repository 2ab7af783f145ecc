//! A value on its way in: collected in the server's buffer, and stored when it is complete.
//!
//! One that the application takes in parts goes to it a buffer at a time. The last part is held back until the client has
//! said that all is right.

use super::{crc, is_in_parts};
use crate::{
    od::{self, Device, Entry, Part, Services},
    AbortCode, Address,
};

/// What has come of a value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Incoming {
    entry: Entry,
    /// The most bytes that are taken; if promised, no fewer either.
    expected: usize,
    is_promised: bool,
    /// Bytes that the application has already.
    passed: usize,
    /// The CRC of those.
    crc: u16,
    /// Bytes behind those, in the buffer. More than fit into it only when the last segment has unused ones.
    held: usize,
}

impl Incoming {
    /// Begins with the value at `address`, of which the client promises `size` bytes, in a buffer of `buffer`.
    pub(super) fn begin<D: Device>(
        device: &mut D,
        buffer: usize,
        address: Address,
        size: Option<u32>,
    ) -> Result<Self, AbortCode> {
        let entry = od::writable(device, address)?;
        let promised = size.map(|size| usize::try_from(size).unwrap_or(usize::MAX));
        let room = if is_in_parts::<D>(entry) {
            device.write_part(address, Part::announcement(promised))?;
            usize::MAX
        } else {
            if let Some(promised) = promised {
                od::check_length(device, entry, promised)?;
            }
            if promised.is_some_and(|promised| promised > buffer) {
                return Err(AbortCode::OUT_OF_MEMORY);
            }
            od::capacity(device, entry).min(buffer)
        };
        Ok(Self {
            entry,
            expected: promised.unwrap_or(room),
            is_promised: promised.is_some(),
            passed: 0,
            crc: 0,
            held: 0,
        })
    }

    pub(super) const fn address(&self) -> Address {
        self.entry.address()
    }

    /// How many bytes are still expected.
    #[inline]
    pub(super) const fn missing(&self) -> usize {
        self.expected.saturating_sub(self.passed + self.held)
    }

    /// How many segments the buffer has room for, 1 to 127, of a value that goes to the application in parts; else 127.
    #[allow(clippy::cast_possible_truncation)] // Up to 127.
    pub(super) fn block_size<D: Device>(&self, buffer: usize) -> u8 {
        if is_in_parts::<D>(self.entry) {
            (buffer / 7).clamp(1, 127) as u8
        } else {
            127
        }
    }

    /// Puts the first `length` bytes of `data` behind those before them.
    #[inline(never)]
    pub(super) fn take<D: Device>(
        &mut self,
        device: &mut D,
        buffer: &mut [u8],
        data: [u8; 7],
        length: usize,
    ) -> Result<(), AbortCode> {
        if self.held + length > buffer.len() {
            self.make_room(device, buffer)?;
        }
        let room = buffer.get_mut(self.held..).unwrap_or_default();
        match room.first_chunk_mut() {
            // What stands beyond the length does not count, and is written over.
            Some(room) => *room = data,
            None => room.iter_mut().zip(data).for_each(|(to, from)| *to = from),
        }
        self.held += length;
        Ok(())
    }

    /// Hands what the buffer holds to the application; of a value that is stored as a whole, nothing.
    #[cold]
    #[inline(never)]
    pub(super) fn make_room<D: Device>(&mut self, device: &mut D, buffer: &[u8]) -> Result<(), AbortCode> {
        if is_in_parts::<D>(self.entry) {
            let bytes = buffer.get(..self.held).unwrap_or(buffer);
            device.write_part(self.address(), self.part(bytes, false))?;
            self.crc = crc(self.crc, bytes);
            self.passed += bytes.len();
            self.held = 0;
        }
        Ok(())
    }

    /// The value is there but for `unused` bytes too many at its end: checks its length and its CRC, if there is one, and
    /// stores it.
    #[inline(never)]
    pub(super) fn finish<D: Device>(
        &self,
        device: &mut D,
        services: &mut impl Services,
        buffer: &[u8],
        unused: u8,
        sum: Option<u16>,
    ) -> Result<(), AbortCode> {
        let held = self.held.saturating_sub(usize::from(unused));
        let length = self.passed + held;
        if length > self.expected {
            return Err(AbortCode::TOO_LONG);
        }
        if self.is_promised && length < self.expected {
            return Err(AbortCode::TOO_SHORT);
        }
        let bytes = buffer.get(..held).ok_or(AbortCode::OUT_OF_MEMORY)?;
        if sum.is_some_and(|sum| sum != crc(self.crc, bytes)) {
            return Err(AbortCode::CRC_ERROR);
        }
        if is_in_parts::<D>(self.entry) {
            return device.write_part(self.address(), self.part(bytes, true));
        }
        od::store(device, services, self.entry, bytes)
    }

    const fn part<'a>(&self, bytes: &'a [u8], is_last: bool) -> Part<'a> {
        Part {
            offset: self.passed,
            bytes,
            is_last,
            announced: if self.is_promised { Some(self.expected) } else { None },
        }
    }
}
