//! Which objects a PDO carries: entries as a client writes them, and what is kept of them.

// Six bytes are taken apart by shifts when passed by value, and just read by reference: ten instructions a TPDO.
#![allow(clippy::trivially_copy_pass_by_ref)]

use super::{mpdo, parameter_u8, Direction};
use crate::{
    od::{self, Access, DataType, Device, Entry, ServiceSet},
    AbortCode, Address,
};

/// Bits that a PDO has room for.
const PDO_BITS: u8 = 64;

/// A mapped object, resolved: where its row stands in the table, where its value stands, and how many bits of the PDO are
/// its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mapped {
    /// Which row of the table it is, the first one being 1; 0 for none.
    row: u16,
    /// Offset of its value among the device's; [`Mapped::ASK`] for one that is not just copied from there.
    slot: u16,
    bits: u8,
}

impl Mapped {
    /// Nothing: bits that mean nothing.
    pub const EMPTY: Self = Self {
        row: 0,
        slot: 0,
        bits: 0,
    };

    /// A slot behind all values.
    const ASK: u16 = u16::MAX;

    /// Resolves an entry of a mapping parameter: index, sub-index and length in bits, from high to low.
    ///
    /// # Errors
    /// * [`AbortCode::NO_SUCH_OBJECT`]
    /// * [`AbortCode::NOT_MAPPABLE`] in this direction, or with this length
    pub(super) fn resolve<D: Device>(device: &D, direction: Direction, value: u32) -> Result<Self, AbortCode> {
        let [bits, sub, i0, i1] = value.to_le_bytes();
        let address = Address::new(u16::from_le_bytes([i0, i1]), sub);
        if let (Direction::Receive, Some(data_type)) = (direction, dummy(device, address)) {
            check_length(data_type, bits)?;
            return Ok(Self { bits, ..Self::EMPTY });
        }
        let table = device.table();
        let place = table.position(address).ok_or(AbortCode::NO_SUCH_OBJECT)?;
        let entry = table.entries.get(place).ok_or(AbortCode::NO_SUCH_OBJECT)?;
        let needed = match direction {
            Direction::Receive => Access::RPDO,
            Direction::Transmit => Access::TPDO,
        };
        if !entry.access.has(needed) {
            return Err(AbortCode::NOT_MAPPABLE);
        }
        check_length(entry.data_type, bits)?;
        let (slot, _) = table.locate(*entry).ok_or(AbortCode::NOT_MAPPABLE)?;
        let asks = entry.access.has(Access::CONSTANT) || entry.access.has(Access::READ_HANDLER);
        let is_copied = !asks && cfg!(target_endian = "little") && device.values().len() <= usize::from(Self::ASK);
        Ok(Self {
            row: u16::try_from(place + 1).map_err(|_| AbortCode::NOT_MAPPABLE)?,
            slot: u16::try_from(slot).ok().filter(|_| is_copied).unwrap_or(Self::ASK),
            bits,
        })
    }

    /// Its row; `None` for a dummy.
    fn entry<D: Device>(self, device: &D) -> Option<Entry> {
        let place = usize::from(self.row).checked_sub(1)?;
        device.table().entries.get(place).copied()
    }

    /// Its bits, all set.
    const fn mask(self) -> u64 {
        u64::MAX.wrapping_shr(self.rest())
    }

    /// How many bits of 64 are not its own.
    const fn rest(&self) -> u32 {
        64u32.wrapping_sub(self.bits as u32)
    }

    /// Eight bytes of the device's values from its slot on, of which its bits are the lowest. `None` of a value that is not
    /// just copied, or of the last ones, behind which there are no eight bytes.
    fn copy<D: Device>(&self, device: &D) -> Option<u64> {
        let bytes = device.values().get(usize::from(self.slot)..)?.first_chunk()?;
        Some(u64::from_le_bytes(*bytes))
    }

    /// The value now, brought up to date by the application; when that refuses, as it was.
    #[cold]
    #[inline(never)]
    fn load<D: Device>(self, device: &mut D) -> u64 {
        let Some(entry) = self.entry(device) else { return 0 };
        if entry.access.has(Access::READ_HANDLER) {
            let _ = device.before_read(entry.address());
        }
        od::load(device, entry).map_or(0, od::Value::bits)
    }

    /// Stores the low bits of `word`, if limits and application allow it.
    fn store<D: Device>(self, device: &mut D, word: u64) {
        if let Some(entry) = self.entry(device) {
            let _ = od::store_number(device, &mut (), entry, word & self.mask());
        }
    }
}

/// Refuses a length in bits that a value of `data_type` does not have.
fn check_length(data_type: DataType, bits: u8) -> Result<(), AbortCode> {
    let whole = 8 * data_type.length();
    if usize::from(bits) == whole && whole != 0 || data_type == DataType::BOOLEAN && bits == 1 {
        Ok(())
    } else {
        Err(AbortCode::NOT_MAPPABLE)
    }
}

/// The data type that a dummy entry stands for (CiA 301, 7.4.7), where the device allows it.
fn dummy<D: Device>(device: &D, address: Address) -> Option<DataType> {
    let number = u8::try_from(address.index).ok()?;
    let allowed = matches!(number, 1..=7) && address.sub == 0 && device.dummy_usage() >> number & 1 != 0;
    allowed.then_some(DataType(number))
}

/// The mapping of a PDO: a part of the room for all of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mapping {
    first: u16,
    room: u8,
    count: u8,
    /// Of all objects together.
    bits: u8,
    /// In bytes.
    length: u8,
}

impl Mapping {
    pub(super) const EMPTY: Self = Self {
        first: 0,
        room: 0,
        count: 0,
        bits: 0,
        length: 0,
    };

    /// A mapping that begins at `first` in the room, and has place for as many objects as 1600h or 1A00h has sub-indices.
    pub(super) fn new<D: Device>(device: &D, index: u16, first: u16) -> Self {
        Self {
            first,
            room: capacity(device, index),
            ..Self::EMPTY
        }
    }

    /// Where in the room the next mapping begins.
    pub(super) const fn end(self) -> u16 {
        self.first.saturating_add(self.room as u16)
    }

    /// How many bytes a PDO has that carries it.
    pub(super) const fn length(self) -> u8 {
        self.length
    }

    /// Whether it has objects.
    pub(super) const fn has_objects(self) -> bool {
        self.count != 0
    }

    /// Whether it has objects, or each PDO says its own.
    pub(super) const fn is_active(self) -> bool {
        self.bits != 0
    }

    /// Whether each PDO says itself which object it carries.
    pub(super) fn is_multiplexed<D: Device>(self) -> bool {
        D::SERVICES.has(ServiceSet::MPDO) && !self.has_objects() && self.is_active()
    }

    /// Takes what the parameter at `index` says; if that cannot be mapped, nothing is.
    pub(super) fn configure<D: Device>(&mut self, device: &D, direction: Direction, index: u16, pool: &mut [Mapped]) {
        self.hold(0, 0);
        let count = parameter_u8(device, index, 0);
        if D::SERVICES.has(ServiceSet::MPDO) && mpdo::is_multiplexed(count.into()) {
            self.hold(0, PDO_BITS);
            return;
        }
        let pool = pool.get_mut(usize::from(self.first)..).unwrap_or_default();
        if let Ok(bits) = resolve(device, direction, index, count.into(), pool) {
            self.hold(count, bits);
        }
    }

    /// It has `count` objects of so many bits together.
    fn hold(&mut self, count: u8, bits: u8) {
        (self.count, self.bits, self.length) = (count, bits, bits.div_ceil(8));
    }

    /// The mapped objects.
    fn objects<'a>(&self, pool: &'a [Mapped]) -> &'a [Mapped] {
        let first = usize::from(self.first);
        pool.get(first..first + usize::from(self.count)).unwrap_or(&[])
    }

    /// The objects' values, the first one in the low bits.
    pub(super) fn collect<D: Device>(&self, device: &mut D, pool: &[Mapped]) -> u64 {
        let mut word = 0u64;
        // Each comes in from above, where what is not its own is shifted out. One of 64 bits is the only one.
        for mapped in self.objects(pool) {
            let value = mapped.copy(device).unwrap_or_else(|| mapped.load(device));
            word = word.wrapping_shr(mapped.bits.into()) | value.wrapping_shl(mapped.rest());
        }
        word.wrapping_shr(64u32.wrapping_sub(self.bits.into()))
    }

    /// Gives the objects their values.
    pub(super) fn distribute<D: Device>(self, device: &mut D, pool: &[Mapped], word: u64) {
        let mut at = 0;
        for mapped in self.objects(pool) {
            mapped.store(device, word.wrapping_shr(at));
            at += u32::from(mapped.bits);
        }
    }

    /// Whether the object at `address` is in it.
    pub(super) fn contains<D: Device>(self, device: &D, pool: &[Mapped], address: Address) -> bool {
        let place = device.table().position(address);
        let mut objects = self.objects(pool).iter();
        place.is_some_and(|place| objects.any(|mapped| usize::from(mapped.row) == place + 1))
    }
}

/// How many objects the parameter at `index` has place for.
fn capacity<D: Device>(device: &D, index: u16) -> u8 {
    device.table().elements(index).min(PDO_BITS)
}

/// Resolves the first `count` entries of the parameter at `index`, into as many places as `pool` has; gives how many bits
/// they have together.
///
/// # Errors
/// * [`AbortCode::PDO_TOO_LONG`] for more entries than there are, or more than 64 bits
/// * what [`Mapped::resolve`] refuses with
#[inline(never)]
pub(super) fn resolve<D: Device>(
    device: &D,
    direction: Direction,
    index: u16,
    count: u32,
    pool: &mut [Mapped],
) -> Result<u8, AbortCode> {
    let count = u8::try_from(count).unwrap_or(u8::MAX);
    if count > capacity(device, index) {
        return Err(AbortCode::PDO_TOO_LONG);
    }
    let mut places = pool.iter_mut();
    let mut bits = 0;
    for nth in 0..count {
        let entry = od::parameter(device, Address::new(index, nth + 1));
        let mapped = Mapped::resolve(device, direction, entry)?;
        bits += mapped.bits;
        if bits > PDO_BITS {
            return Err(AbortCode::PDO_TOO_LONG);
        }
        if let Some(place) = places.next() {
            *place = mapped;
        }
    }
    Ok(bits)
}
