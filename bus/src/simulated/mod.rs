//! Devices that are put together at run time: of an EDS file, or object by object.
//!
//! A simulated device is the firmware's [`Node`](lexican_runtime::Node) with its SDO servers, PDOs, NMT, LSS and the rest, over
//! a dictionary that is laid out here instead of by the compiler. It has no application: its values change when they are
//! written, and keep still otherwise.

mod complete;
pub mod memory;
mod network;
mod object;
mod seeds;

use std::collections::HashSet;

use lexican_eds::ir;
use lexican_runtime::heartbeat::Watch;
use lexican_runtime::od::{Access, DataType, Device, Entry, Extra, Table, Value};
use lexican_runtime::pdo::{Mapped, Parts, Room, Rpdo, Tpdo};
use lexican_runtime::sdo::Channel;
use lexican_runtime::{
    AbortCode, Address, Event,
    lss::{BitRate, BitRates},
};

pub use complete::complete;
pub use memory::Memory;
pub use network::Network;
pub use object::Object;

/// Room for the PDOs of a simulated device.
#[derive(Clone, Debug)]
pub struct SimulatedPdos {
    tpdos: Vec<Tpdo>,
    rpdos: Vec<Rpdo>,
    mapped: Vec<Mapped>,
}

impl Room for SimulatedPdos {
    fn parts(&mut self) -> Parts<'_> {
        Parts {
            tpdos: &mut self.tpdos,
            rpdos: &mut self.rpdos,
            mapped: &mut self.mapped,
        }
    }
}

/// How many events are kept at most.
const TOLD: usize = 4096;

/// How many bytes the values of a dictionary have at most, and its limits: their offsets have 16 bits.
const ROOM: usize = 0xFFFF;

/// A device without an application.
#[derive(Clone, Debug)]
pub struct Simulated {
    places: Vec<Entry>,
    seeds: Vec<u16>,
    extras: Vec<Extra>,
    constants: Vec<u8>,
    values: Vec<u8>,
    defaults: Vec<u8>,
    longest: usize,
    dummy_usage: u8,
    bit_rates: BitRates,
    memory: Option<Memory>,
    told: Vec<Event>,
    left_out: Vec<Address>,
}

impl Simulated {
    /// The device with these objects.
    #[must_use]
    pub fn new(objects: &[Object]) -> Self {
        let mut device = Self {
            places: Vec::new(),
            seeds: Vec::new(),
            extras: Vec::new(),
            constants: Vec::new(),
            values: Vec::new(),
            defaults: Vec::new(),
            longest: 0,
            dummy_usage: 0,
            bit_rates: BitRates::ALL,
            memory: None,
            told: Vec::new(),
            left_out: Vec::new(),
        };
        let mut known = HashSet::new();
        let mut entries = Vec::with_capacity(objects.len());
        for object in objects {
            if known.insert(object.address) && device.has_room(object) {
                entries.push(device.lay_out(object));
            } else {
                device.left_out.push(object.address);
            }
        }
        (device.places, device.seeds) = seeds::place(&entries);
        device.values.clone_from(&device.defaults);
        device
    }

    /// The objects that it does not have though they were asked for: an address for the second time, and what is beyond the
    /// 64 KiB of a dictionary.
    #[must_use]
    pub fn left_out(&self) -> &[Address] {
        &self.left_out
    }

    /// What its application was told, the oldest first; of very much only the newest.
    #[must_use]
    pub fn told(&self) -> &[Event] {
        &self.told
    }

    /// The device of an EDS file.
    #[must_use]
    pub fn of(dictionary: &ir::Dictionary) -> Self {
        let objects: Vec<Object> = dictionary.entries().map(Object::from).collect();
        let simple = dictionary
            .dummies
            .iter()
            .map(|data_type| data_type.index())
            .filter(|&index| index < 8);
        Self::new(&objects)
            .with_dummies(simple.fold(0, |all, index| all | 1 << index))
            .with_bit_rates(bit_rates(&dictionary.device.baud_rates))
    }

    /// The device with these dummy entries: bit 1 for 0001h, up to bit 7 for 0007h.
    #[must_use]
    pub fn with_dummies(mut self, dummy_usage: u8) -> Self {
        self.dummy_usage = dummy_usage;
        self
    }

    /// The device with this memory for what is stored.
    #[must_use]
    pub fn with_memory(mut self, memory: &Memory) -> Self {
        self.memory = Some(memory.clone());
        self
    }

    /// The device with these bit rates: bit 0 for row 0 of CiA 305's table.
    #[must_use]
    pub fn with_bit_rates(mut self, bit_rates: u16) -> Self {
        self.bit_rates = BitRates(bit_rates);
        self
    }

    /// Whether its value, its limits and its extra fit.
    fn has_room(&self, object: &Object) -> bool {
        let length = object
            .data_type
            .width()
            .max(2 + object.capacity.max(object.default.len()));
        let limits = 2 * object.data_type.width();
        self.defaults.len() + length <= ROOM && self.constants.len() + limits <= ROOM && self.extras.len() < ROOM
    }

    /// Gives the object room among the values, and its extras.
    fn lay_out(&mut self, object: &Object) -> Entry {
        let slot = self.defaults.len();
        let mut access = object.access;
        let mut at = slot;
        if object.data_type.length() == 0 {
            let capacity = self.string(object);
            (access, at) = (access.with(Access::EXTRA), self.extras.len());
            self.extras.push(Extra::new(slot, capacity));
        } else {
            self.defaults.extend(widened(object.data_type, &object.default));
        }
        if let Some((low, high)) = &object.limits {
            (access, at) = (access.with(Access::EXTRA), self.extras.len());
            self.extras.push(Extra::new(slot, self.constants.len()));
            self.constants.extend(little_endian(object.data_type, low));
            self.constants.extend(little_endian(object.data_type, high));
        }
        Entry::new(object.address.index, object.address.sub, object.data_type, access, at)
    }

    /// Lays out a string; gives its capacity.
    fn string(&mut self, object: &Object) -> usize {
        let length = object.default.len();
        let capacity = object.capacity.max(length);
        self.longest = self.longest.max(capacity);
        self.defaults
            .extend(u16::try_from(length).unwrap_or(u16::MAX).to_le_bytes());
        self.defaults.extend(&object.default);
        self.defaults.resize(self.defaults.len() + capacity - length, 0);
        capacity
    }
}

/// The rows of CiA 305's table for bit rates in kbit/s.
fn bit_rates(rates: &ir::BaudRates) -> u16 {
    let rows = (0..10).filter(|&row| {
        let rate = BitRate::from_index(row).and_then(BitRate::kbit_per_s);
        rate.is_some_and(|rate| rates.0.contains(&rate))
    });
    rows.fold(0, |bits, row| bits | 1 << row)
}

/// `bytes` from the bus as wide as in the dictionary, little-endian, with the sign of an INTEGER.
fn little_endian(data_type: DataType, bytes: &[u8]) -> Vec<u8> {
    let negative = data_type.is_signed() && bytes.last().is_some_and(|byte| byte & 0x80 != 0);
    let mut wide = bytes.to_vec();
    wide.resize(data_type.width(), if negative { 0xFF } else { 0x00 });
    wide
}

/// The same in the byte order of this machine. TIME_OF_DAY stands as on the bus.
fn widened(data_type: DataType, bytes: &[u8]) -> Vec<u8> {
    let mut wide = little_endian(data_type, bytes);
    if cfg!(target_endian = "big") && data_type.width() != 6 {
        wide.reverse();
    }
    wide
}

impl Device for Simulated {
    type Buffer = Vec<u8>;
    type Pdos = SimulatedPdos;
    type Storage = Memory;
    type Watches = Vec<Watch>;
    type Servers = Vec<Channel<Vec<u8>>>;

    fn table(&self) -> Table<'_> {
        Table {
            entries: &self.places,
            seeds: &self.seeds,
            extras: &self.extras,
            constants: &self.constants,
        }
    }

    fn values(&self) -> &[u8] {
        &self.values
    }

    fn values_mut(&mut self) -> &mut [u8] {
        &mut self.values
    }

    fn defaults(&self) -> &[u8] {
        &self.defaults
    }

    fn buffer(&self) -> Self::Buffer {
        vec![0; self.longest.max(8)]
    }

    fn pdos(&self) -> Self::Pdos {
        let count = |indices: [std::ops::RangeInclusive<u16>; 2], is_meant: fn(u8) -> bool| {
            let entries = self.places.iter();
            let meant =
                |entry: &&Entry| indices.iter().any(|indices| indices.contains(&entry.index)) && is_meant(entry.sub);
            entries.filter(meant).count()
        };
        let [rpdos, tpdos] =
            [0x1400..=0x15FF, 0x1800..=0x19FF].map(|range| count([range.clone(), range], |sub| sub == 1));
        let mapped = count([0x1600..=0x17FF, 0x1A00..=0x1BFF], |sub| sub != 0);
        SimulatedPdos {
            tpdos: vec![Tpdo::EMPTY; tpdos],
            rpdos: vec![Rpdo::EMPTY; rpdos],
            mapped: vec![Mapped::EMPTY; mapped],
        }
    }

    fn watches(&self) -> Self::Watches {
        let watched = |entry: &&Entry| entry.index == 0x1016 && entry.sub != 0;
        vec![Watch::NOBODY; self.places.iter().filter(watched).count()]
    }

    fn servers(&self) -> Self::Servers {
        let servers = self.places.iter();
        let servers = servers.filter(|entry| matches!((entry.index, entry.sub), (0x1201..=0x127F, 1)));
        servers.map(|_| Channel::new(self.buffer())).collect()
    }

    fn dummy_usage(&self) -> u8 {
        self.dummy_usage
    }

    fn storage(&mut self) -> Option<&mut Memory> {
        self.memory.as_mut()
    }

    fn bit_rates(&self) -> BitRates {
        self.bit_rates
    }

    fn event(&mut self, event: Event) {
        if self.told.len() == TOLD {
            self.told.drain(..TOLD / 2);
        }
        self.told.push(event);
    }

    fn before_read(&mut self, _: Address) -> Result<(), AbortCode> {
        Ok(())
    }

    fn before_write(&mut self, _: Address, _: Value<'_>) -> Result<(), AbortCode> {
        Ok(())
    }
}
