//! PDO mappings, as the rules about them see them.

use crate::{
    ir::{Address, DataType, Dictionary, Direction, Entry, Pdo, Value},
    span::Span,
};

/// As many objects can a PDO map (CiA 301, object 1600h); sub-index 0 above it marks a multiplexed PDO.
pub(super) const MOST_ENTRIES: u8 = 64;

/// A mapping entry that sub-index 0 counts among those in force.
pub(super) struct Mapped<'a> {
    pub(super) pdo: Pdo<'a>,
    /// The mapping entry itself.
    pub(super) place: Address,
    pub(super) span: Span,
    /// What is mapped.
    pub(super) address: Address,
    pub(super) bits: u8,
}

impl Mapped<'_> {
    /// The data type that fills the place of an object (CiA 301, 7.4.7); `None` when an object is mapped.
    pub(super) fn dummy(&self) -> Option<DataType> {
        DataType::from_index(self.address.index).filter(|_| self.address.sub == 0)
    }
}

/// All PDOs, RPDOs first.
pub(super) fn pdos(dictionary: &Dictionary) -> impl Iterator<Item = Pdo<'_>> {
    let directions = [Direction::Receive, Direction::Transmit].into_iter();
    directions.flat_map(|direction| dictionary.pdos(direction))
}

/// How a message calls the PDO: `TPDO 1`.
pub(super) fn label(pdo: &Pdo<'_>) -> String {
    format!("{} {}", kind(pdo.direction), pdo.number)
}

/// `RPDO` or `TPDO`.
pub(super) const fn kind(direction: Direction) -> &'static str {
    match direction {
        Direction::Receive => "RPDO",
        Direction::Transmit => "TPDO",
    }
}

/// The mapping entries in force of all PDOs.
pub(super) fn all_mapped(dictionary: &Dictionary) -> impl Iterator<Item = Mapped<'_>> {
    pdos(dictionary).flat_map(mapped)
}

/// The mapping entries in force; an empty one is none.
pub(super) fn mapped(pdo: Pdo<'_>) -> impl Iterator<Item = Mapped<'_>> {
    counted(pdo).filter_map(move |entry| {
        let value = unsigned(entry.default.as_ref()).filter(|value| *value != 0)?;
        // `iiiisslh`: index, sub-index, length.
        let [bits, sub, low, high, ..] = value.to_le_bytes();
        Some(Mapped {
            pdo,
            place: entry.address,
            span: entry.spans.default,
            address: Address::new(u16::from_le_bytes([low, high]), sub),
            bits,
        })
    })
}

/// The sub-objects that sub-index 0 counts, or all when it has no value; none of a multiplexed PDO.
pub(super) fn counted(pdo: Pdo<'_>) -> impl Iterator<Item = &Entry> {
    let count = count(pdo).unwrap_or(MOST_ENTRIES);
    let count = if count > MOST_ENTRIES { 0 } else { count };
    let entries = pdo.mapping.into_iter().flat_map(|object| &object.entries);
    entries.filter(move |entry| (1..=count).contains(&entry.address.sub))
}

/// Sub-index 0 of the mapping.
pub(super) fn count(pdo: Pdo<'_>) -> Option<u8> {
    let value = unsigned(pdo.mapping?.entry(0)?.default.as_ref())?;
    u8::try_from(value).ok()
}

/// Whether the objects that are mapped can be changed; `None` without mapping.
pub(super) fn is_variable(pdo: Pdo<'_>) -> Option<bool> {
    Some(pdo.mapping?.entry(0)?.access.writable())
}

pub(super) fn unsigned(value: Option<&Value>) -> Option<u64> {
    match value {
        Some(Value::Unsigned(value)) => Some(*value),
        _ => None,
    }
}
