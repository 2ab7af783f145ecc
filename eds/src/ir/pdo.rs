//! The PDO view: communication and mapping parameters read together.

use super::{Address, Dictionary, Entry, Object, Value};
use crate::span::Span;

/// Which way a PDO goes, seen from the device.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// RPDO: 1400h and 1600h.
    Receive,
    /// TPDO: 1800h and 1A00h.
    Transmit,
}

/// A PDO: its communication object (1400h, 1800h …) and its mapping object (1600h, 1A00h …).
#[derive(Clone, Copy, Debug)]
pub struct Pdo<'a> {
    /// 1 to 512.
    pub number: u16,
    /// RPDO or TPDO.
    pub direction: Direction,
    /// The communication parameter.
    pub communication: Option<&'a Object>,
    /// The mapping parameter.
    pub mapping: Option<&'a Object>,
}

/// One entry of a mapping: `iiiisslh`, index, sub-index and length in bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MappedObject {
    /// What is mapped.
    pub address: Address,
    /// How many bits of it.
    pub bits: u8,
    /// Where the mapping entry's value stands.
    pub span: Span,
}

impl Dictionary {
    /// The RPDOs or TPDOs, by number: every index that has a communication or a mapping object.
    pub fn pdos(&self, direction: Direction) -> impl Iterator<Item = Pdo<'_>> {
        let base: u16 = match direction {
            Direction::Receive => 0x1400,
            Direction::Transmit => 0x1800,
        };
        (0..512).filter_map(move |offset| {
            let pdo = Pdo {
                number: offset + 1,
                direction,
                communication: self.object(base + offset),
                mapping: self.object(base + 0x200 + offset),
            };
            (pdo.communication.is_some() || pdo.mapping.is_some()).then_some(pdo)
        })
    }
}

impl<'a> Pdo<'a> {
    /// The COB-ID, sub-index 1 of the communication object; may be a formula.
    #[must_use]
    pub fn cob_id(&self) -> Option<&'a Value> {
        self.communication?.entry(1)?.default.as_ref()
    }

    /// The mapped objects that the file gives: sub-indices 1 to 64 whose value is not 0, whatever sub-index 0 says.
    pub fn mapped(&self) -> impl Iterator<Item = MappedObject> + 'a {
        self.mapping
            .into_iter()
            .flat_map(|object| &object.entries)
            .filter_map(mapped_object)
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "the fields of the mapping entry are cut out of it"
)]
fn mapped_object(entry: &Entry) -> Option<MappedObject> {
    match entry.default {
        Some(Value::Unsigned(value)) if value != 0 && (1..=64).contains(&entry.address.sub) => Some(MappedObject {
            address: Address::new((value >> 16) as u16, (value >> 8) as u8),
            bits: value as u8,
            span: entry.spans.default,
        }),
        _ => None,
    }
}
