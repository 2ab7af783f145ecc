//! How many PDOs a dictionary has objects for.

use std::ops::RangeInclusive;

use lexican_eds::ir::{DataType, Dictionary};

/// What the runtime is to keep room for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Pdos {
    pub(crate) tpdos: usize,
    pub(crate) rpdos: usize,
    /// Sub-indices, from 1 on, of the mapping parameters.
    pub(crate) mapped: usize,
    /// The dummy entries that an RPDO may have: bit 1 for 0001h, up to bit 7 for 0007h.
    pub(crate) dummy_usage: u8,
}

impl Pdos {
    pub(crate) fn of(dictionary: &Dictionary) -> Self {
        Self {
            tpdos: count(dictionary, 0x1800..=0x19FF, |sub| sub == 1),
            rpdos: count(dictionary, 0x1400..=0x15FF, |sub| sub == 1),
            mapped: count(dictionary, 0x1600..=0x17FF, is_mapped) + count(dictionary, 0x1A00..=0x1BFF, is_mapped),
            dummy_usage: dictionary.dummies.iter().fold(0, |usage, dummy| usage | bit(*dummy)),
        }
    }
}

fn count(dictionary: &Dictionary, indices: RangeInclusive<u16>, is_meant: fn(u8) -> bool) -> usize {
    let addresses = dictionary.entries().map(|entry| entry.address);
    let meant = addresses.filter(|address| indices.contains(&address.index) && is_meant(address.sub));
    meant.count()
}

/// A PDO has 64 bits, so no more objects.
fn is_mapped(sub: u8) -> bool {
    matches!(sub, 1..=64)
}

fn bit(dummy: DataType) -> u8 {
    match dummy.index() {
        number @ 1..=7 => 1 << number,
        _ => 0,
    }
}
