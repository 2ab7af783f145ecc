//! A PDO with the mapping that is in force.

use std::collections::BTreeMap;

use lexican_eds::ir::{DataType, Value};
use lexican_runtime::{
    Address,
    wire::{CanId, CobId},
};

use super::{Description, value};

/// Which way a PDO goes, seen from the node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Direction {
    /// RPDO: 1400h and 1600h.
    Receive,
    /// TPDO: 1800h and 1A00h.
    Transmit,
}

/// An object in a PDO.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field<'d> {
    /// What is mapped.
    pub address: Address,
    /// How many bits of it, 1 to 64.
    pub bits: u8,
    /// What the file calls it; empty for an object that it does not have.
    pub name: &'d str,
    /// Of an object that the file does not have, none.
    pub data_type: Option<DataType>,
}

/// A PDO of a node.
#[derive(Clone, Debug)]
pub(super) struct Pdo<'d> {
    /// 1 to 512.
    pub(super) number: u16,
    pub(super) direction: Direction,
    /// `None` for one that is switched off.
    pub(super) can_id: Option<CanId>,
    /// Sub-index 0 of the mapping says that each frame names its object.
    pub(super) is_multiplexed: bool,
    pub(super) fields: Vec<Field<'d>>,
}

impl Direction {
    /// The index of the first communication parameter.
    const fn base(self) -> u16 {
        match self {
            Self::Receive => 0x1400,
            Self::Transmit => 0x1800,
        }
    }

    /// The PDO that an object from 1400h to 1BFFh configures: direction, and number from 1.
    pub(super) const fn of(index: u16) -> Option<(Self, u16)> {
        match index {
            0x1400..=0x17FF => Some((Self::Receive, (index & 0x1FF) + 1)),
            0x1800..=0x1BFF => Some((Self::Transmit, (index & 0x1FF) + 1)),
            _ => None,
        }
    }
}

impl<'d> Pdo<'d> {
    /// The PDO as `values` configure it; `None` when they have no COB-ID of it.
    pub(super) fn new(
        direction: Direction,
        number: u16,
        values: &BTreeMap<Address, u64>,
        description: Option<&'d Description>,
    ) -> Option<Self> {
        let communication = direction.base() + (number - 1);
        let mapping = communication + 0x200;
        let cob_id = u32::try_from(*values.get(&Address::new(communication, 1))?)
            .ok()
            .map(CobId)?;
        let count = values.get(&Address::new(mapping, 0)).copied().unwrap_or(0);
        let count = u8::try_from(count).unwrap_or(0);
        let is_multiplexed = count >= 0xFE;
        let subs = 1..=if is_multiplexed { 0 } else { count.min(64) };
        let entries = subs.filter_map(|sub| values.get(&Address::new(mapping, sub)));
        Some(Self {
            number,
            direction,
            can_id: cob_id.can_id().filter(|_| cob_id.is_valid()),
            is_multiplexed,
            fields: entries.filter_map(|entry| Field::new(*entry, description)).collect(),
        })
    }
}

impl<'d> Field<'d> {
    /// What a mapping entry, `iiiisslh`, names.
    fn new(entry: u64, description: Option<&'d Description>) -> Option<Self> {
        let [bits, sub, i0, i1, ..] = entry.to_le_bytes();
        let address = Address::new(u16::from_le_bytes([i0, i1]), sub);
        let object = description.and_then(|description| description.object(address));
        let dummy = DataType::from_index(address.index);
        (1..=64).contains(&bits).then_some(Self {
            address,
            bits,
            name: object.map_or(if dummy.is_some() { "dummy" } else { "" }, |object| &object.name),
            data_type: object.map(|object| object.data_type).or(dummy),
        })
    }

    /// The object's value in `word` from bit `offset` on.
    pub(super) fn value(&self, word: u64, offset: u32) -> Value {
        let word = word.checked_shr(offset).unwrap_or(0);
        let bits = word & (u64::MAX >> (64 - u32::from(self.bits)));
        value::of_bits(bits, self.bits, self.data_type)
    }
}
