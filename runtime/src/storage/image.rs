//! An image in a slot: words ↔ records.

use super::{capabilities, Failed, Slot, Storage};
use crate::{lss::BitRate, od::Device, Address, NodeId};

/// `Lx`, and the format's version.
const MAGIC: [u8; 4] = *b"Lx\x01\x00";
/// Beyond it no image goes: so an application's mistake cannot keep a reader busy for ever.
const LIMIT: usize = 0x4_0000;

/// Where the record of LSS stands; no object has this index.
pub(super) const SETTINGS: Address = Address::new(0x0001, 0x00);
/// Ends the records; no object has this index.
const END: Address = Address::new(0x0000, 0x00);

/// What LSS stores.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Settings {
    pub(crate) node_id: NodeId,
    pub(crate) bit_rate: Option<BitRate>,
}

impl Settings {
    /// As the bytes of its record.
    pub(super) fn bytes(self) -> [u8; 2] {
        [self.node_id.get(), self.bit_rate.map_or(0xFF, BitRate::index)]
    }
}

/// A whole image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Image {
    pub(super) slot: Slot,
    sequence: u32,
}

/// The beginning of a record; its value follows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Record {
    pub(super) address: Address,
    pub(super) length: usize,
}

impl Record {
    /// Bytes before the value.
    pub(super) const HEAD: usize = 5;
    /// Bytes of an image that are no records: its head, its end, its check value, and what fills the last word.
    pub(super) const AROUND: usize = 8 + Self::HEAD + 4 + 7;
}

/// The newest whole image.
pub(crate) fn newest<D: Device>(device: &mut D) -> Option<Image> {
    if capabilities(device) == 0 {
        return None;
    }
    let storage = device.storage()?;
    let [a, b] = [Slot::A, Slot::B].map(|slot| whole(storage, slot));
    match (a, b) {
        (Some(a), Some(b)) => {
            // The numbers may have wrapped.
            let is_a = a.sequence.wrapping_sub(b.sequence) < 0x8000_0000;
            Some(if is_a { a } else { b })
        }
        (a, b) => a.or(b),
    }
}

/// The image in `slot`, if it is whole.
#[inline(never)]
fn whole<S: Storage>(storage: &mut S, slot: Slot) -> Option<Image> {
    let mut reader = Reader::new(slot);
    let [m0, m1, m2, m3, s0, s1, s2, s3] = reader.word(storage);
    if [m0, m1, m2, m3] != MAGIC {
        return None;
    }
    let sequence = u32::from_le_bytes([s0, s1, s2, s3]);
    while let Some(record) = reader.record(storage) {
        reader.skip(storage, record.length);
    }
    let expected = (!reader.check).to_le_bytes();
    let mut check = [0; 4];
    reader.fill(storage, &mut check);
    (check == expected && !reader.has_failed).then_some(Image { slot, sequence })
}

/// Reads a slot from its beginning on. What cannot be read is 0, and so the records come to an end.
pub(super) struct Reader {
    slot: Slot,
    has_failed: bool,
    offset: usize,
    word: [u8; 8],
    check: u32,
}

impl Reader {
    fn new(slot: Slot) -> Self {
        Self {
            slot,
            has_failed: false,
            offset: 0,
            word: [0; 8],
            check: CRC_START,
        }
    }

    /// Reads the records of a whole image.
    #[inline(never)]
    pub(super) fn of(image: Image) -> Self {
        Self {
            offset: 8,
            ..Self::new(image.slot)
        }
    }

    /// The next bytes.
    #[inline(never)]
    pub(super) fn fill<S: Storage>(&mut self, storage: &mut S, bytes: &mut [u8]) {
        for byte in bytes {
            let nth = self.offset % 8;
            if nth == 0 {
                let word = storage.read(self.slot, self.offset).ok();
                let word = word.filter(|_| self.offset < LIMIT && !self.has_failed);
                self.has_failed = word.is_none();
                self.word = word.unwrap_or_default();
            }
            *byte = self.word.get(nth).copied().unwrap_or(0);
            self.offset += 1;
            self.check = crc(self.check, *byte);
        }
    }

    /// Reads so many bytes for nothing but the check value.
    pub(super) fn skip<S: Storage>(&mut self, storage: &mut S, bytes: usize) {
        for _ in 0..bytes {
            self.fill(storage, &mut [0]);
        }
    }

    /// The next record; `None` at the end.
    pub(super) fn record<S: Storage>(&mut self, storage: &mut S) -> Option<Record> {
        let mut head = [0; Record::HEAD];
        self.fill(storage, &mut head);
        let [i0, i1, sub, l0, l1] = head;
        let address = Address::new(u16::from_le_bytes([i0, i1]), sub);
        let length = usize::from(u16::from_le_bytes([l0, l1]));
        (address != END).then_some(Record { address, length })
    }

    fn word<S: Storage>(&mut self, storage: &mut S) -> [u8; 8] {
        let mut word = [0; 8];
        self.fill(storage, &mut word);
        word
    }
}

/// Writes a new image. What cannot be written is missed when the image is read again, before it is relied upon.
pub(super) struct Writer {
    image: Image,
    has_failed: bool,
    offset: usize,
    word: [u8; 8],
    check: u32,
}

impl Writer {
    /// Begins the image that takes the place of `old`, in the other slot.
    pub(super) fn begin<S: Storage>(storage: &mut S, old: Option<Image>) -> Self {
        let (slot, sequence) = match old {
            Some(old) => (old.slot.other(), old.sequence.wrapping_add(1)),
            None => (Slot::A, 0),
        };
        let mut writer = Self {
            image: Image { slot, sequence },
            has_failed: storage.erase(slot).is_err(),
            offset: 0,
            word: [0; 8],
            check: CRC_START,
        };
        writer.put(storage, &MAGIC);
        writer.put(storage, &sequence.to_le_bytes());
        writer
    }

    /// The next bytes.
    #[inline(never)]
    pub(super) fn put<S: Storage>(&mut self, storage: &mut S, bytes: &[u8]) {
        for byte in bytes {
            if let Some(place) = self.word.get_mut(self.offset % 8) {
                *place = *byte;
            }
            self.check = crc(self.check, *byte);
            self.offset += 1;
            if self.offset % 8 == 0 && !self.has_failed {
                self.has_failed = storage.write(self.image.slot, self.offset - 8, self.word).is_err();
            }
        }
    }

    /// Begins a record; its value, of `length` bytes, is to follow.
    #[inline(never)]
    #[allow(clippy::cast_possible_truncation)] // A dictionary has 64 KiB of values.
    pub(super) fn record<S: Storage>(&mut self, storage: &mut S, address: Address, length: usize) {
        let [i0, i1] = address.index.to_le_bytes();
        let [l0, l1] = (length as u16).to_le_bytes();
        self.put(storage, &[i0, i1, address.sub, l0, l1]);
    }

    /// Ends the image, and gives it.
    pub(super) fn end<S: Storage>(mut self, storage: &mut S) -> Result<Image, Failed> {
        self.record(storage, END, 0);
        let check = (!self.check).to_le_bytes();
        self.put(storage, &check);
        while self.offset % 8 != 0 {
            self.put(storage, &[0xFF]);
        }
        if self.has_failed {
            return Err(Failed);
        }
        storage.finish(self.image.slot)?;
        Ok(self.image)
    }
}

const CRC_START: u32 = 0xFFFF_FFFF;

/// CRC-32 (ISO 3309), a bit at a time: a table would take more flash than it saves time.
#[inline(never)]
fn crc(check: u32, byte: u8) -> u32 {
    (0..8).fold(check ^ u32::from(byte), |check, _| {
        check >> 1 ^ if check & 1 == 0 { 0 } else { 0xEDB8_8320 }
    })
}

#[cfg(test)]
mod tests {
    use super::{crc, CRC_START};

    #[test]
    fn the_check_value_is_that_of_iso_3309() {
        assert_eq!(
            !b"123456789".iter().fold(CRC_START, |check, byte| crc(check, *byte)),
            0xCBF4_3926
        );
    }
}
