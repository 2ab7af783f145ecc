//! A device that is put together while the test runs: slow, and about any dictionary.

use lexican_eds::ir;
use lexican_runtime::heartbeat::Watch;
use lexican_runtime::od::{Access, DataType, Device, Entry, Extra, Table, Value, bucket_of, place_of};
use lexican_runtime::pdo::{Mapped, Parts, Room, Rpdo, Tpdo};
use lexican_runtime::sdo::Channel;
use lexican_runtime::{
    AbortCode, Address, Event,
    lss::{BitRate, BitRates},
};

use crate::memory::Memory;

/// A value that a simulated device is to have.
#[derive(Clone, Debug)]
pub struct Object {
    /// Index and sub-index.
    pub address: Address,
    /// The data type.
    pub data_type: DataType,
    /// [`Access::READ`], [`Access::WRITE`], [`Access::NODE_ID`] and whether it may be mapped.
    pub access: Access,
    /// The value after power-on, as on the bus.
    pub default: Vec<u8>,
    /// Low and high limit, as on the bus.
    pub limits: Option<(Vec<u8>, Vec<u8>)>,
    /// How many bytes a string may have; the longer of this and the default counts.
    pub capacity: usize,
}

impl Object {
    /// A number of 1, 2, 4 or 8 bytes without limits, unsigned, which a client may read and write.
    ///
    /// # Panics
    /// When it has another length.
    #[must_use]
    pub fn number(index: u16, sub: u8, length: usize, default: u64) -> Self {
        let data_type = match length {
            1 => DataType::UNSIGNED8,
            2 => DataType::UNSIGNED16,
            4 => DataType::UNSIGNED32,
            8 => DataType::UNSIGNED64,
            _ => panic!("no number has {length} bytes"),
        };
        Self {
            address: Address::new(index, sub),
            data_type,
            access: Access::READ.with(Access::WRITE),
            default: default.to_le_bytes()[..length].to_vec(),
            limits: None,
            capacity: 0,
        }
    }

    /// The same with `access` added.
    #[must_use]
    pub fn with(mut self, access: Access) -> Self {
        self.access = self.access.with(access);
        self
    }
}

/// How many bytes a string of an EDS may have at least; an EDS does not say.
const CAPACITY: usize = 64;

impl From<&ir::Entry> for Object {
    fn from(entry: &ir::Entry) -> Self {
        let bytes = |value: &ir::Value| value.to_bytes(entry.data_type, None);
        let length = entry.data_type.bytes().unwrap_or(0);
        let counted = entry.address.index == 0x1003 && entry.address.sub != 0;
        let formula = matches!(entry.default, Some(ir::Value::NodeIdPlus(_)));
        Self {
            address: Address::new(entry.address.index, entry.address.sub),
            data_type: DataType(u8::try_from(entry.data_type.index()).expect("a static type")),
            access: access(entry.access)
                .with(if formula { Access::NODE_ID } else { Access(0) })
                .with(if counted { Access::COUNTED } else { Access(0) })
                .with(mappable(entry)),
            default: entry.default.as_ref().map_or_else(|| vec![0; length], bytes),
            limits: entry
                .low
                .as_ref()
                .zip(entry.high.as_ref())
                .map(|(low, high)| (bytes(low), bytes(high))),
            capacity: if length == 0 { CAPACITY } else { 0 },
        }
    }
}

fn access(access: ir::AccessType) -> Access {
    match (access.readable(), access.writable()) {
        (true, true) => Access::READ.with(Access::WRITE),
        (false, _) => Access::WRITE,
        (true, false) => Access::READ,
    }
}

/// Into which PDOs it may be mapped (CiA 306-1, AccessType).
fn mappable(entry: &ir::Entry) -> Access {
    match entry.access {
        _ if !entry.pdo_mapping => Access(0),
        ir::AccessType::Rw => Access::TPDO.with(Access::RPDO),
        ir::AccessType::Wo | ir::AccessType::Rww => Access::RPDO,
        _ => Access::TPDO,
    }
}

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
        };
        let entries: Vec<Entry> = objects.iter().map(|object| device.lay_out(object)).collect();
        device.place(&entries);
        device.values.clone_from(&device.defaults);
        device
    }

    /// What its application was told, the oldest first.
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
            .extend(u16::try_from(length).expect("64 KiB").to_le_bytes());
        self.defaults.extend(&object.default);
        self.defaults.resize(self.defaults.len() + capacity - length, 0);
        capacity
    }

    /// Finds the seeds of a perfect hash: for the fullest bucket first the least seed that puts all its entries on free
    /// places.
    fn place(&mut self, entries: &[Entry]) {
        let places = entries.len() + entries.len() / 32 + 1;
        self.places = vec![Entry::EMPTY; places];
        self.seeds = vec![0; entries.len() / 3 + 1];
        let mut buckets: Vec<Vec<Entry>> = vec![Vec::new(); self.seeds.len()];
        for entry in entries {
            buckets[bucket_of(entry.address(), self.seeds.len())].push(*entry);
        }
        let mut order: Vec<usize> = (0..buckets.len()).collect();
        order.sort_by_key(|&bucket| std::cmp::Reverse(buckets[bucket].len()));
        for bucket in order {
            let seed = (0..=u16::MAX).find(|&seed| self.try_seed(bucket, &buckets[bucket], seed));
            assert!(seed.is_some(), "no seed for a bucket of {}", buckets[bucket].len());
        }
    }

    /// Puts the entries of a bucket on their places, if `seed` gives them free ones.
    fn try_seed(&mut self, bucket: usize, entries: &[Entry], seed: u16) -> bool {
        self.seeds[bucket] = seed;
        let places = self.places.len();
        let mut wanted: Vec<usize> = entries
            .iter()
            .map(|entry| place_of(entry.address(), &self.seeds, places))
            .collect();
        let free = wanted.iter().all(|&place| self.places[place] == Entry::EMPTY);
        wanted.sort_unstable();
        if !free || wanted.windows(2).any(|pair| pair[0] == pair[1]) {
            return false;
        }
        for entry in entries {
            let place = place_of(entry.address(), &self.seeds, places);
            self.places[place] = *entry;
        }
        true
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
        self.told.push(event);
    }

    fn before_read(&mut self, _: Address) -> Result<(), AbortCode> {
        Ok(())
    }

    fn before_write(&mut self, _: Address, _: Value<'_>) -> Result<(), AbortCode> {
        Ok(())
    }
}
