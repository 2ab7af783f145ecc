//! The rows of the runtime's table.

use lexican_eds::ir::{AccessType, Address, Entry, Value};

use super::{Item, Pool, Storage, limits::limits, pool::stored};

/// Where a value stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// In a field of the struct: the item's number in the plan, and bytes from the field's start.
    Field(usize, usize),
    /// In the pool of constants.
    Constant(usize),
}

/// What a row says of where its value is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Slot {
    Place(Place),
    /// The number of an extra row.
    Extra(usize),
}

/// A row: one value.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row<'a> {
    pub(crate) entry: &'a Entry,
    pub(crate) constant: bool,
    /// Given and taken in parts.
    pub(crate) parts: bool,
    pub(crate) reads: bool,
    pub(crate) writes: bool,
    pub(crate) slot: Slot,
}

/// A row of what does not fit into a row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extra {
    pub(crate) address: Address,
    pub(crate) place: Place,
    /// A string's capacity (of a constant one its length), a number's limits in the pool.
    pub(crate) detail: usize,
}

/// The rows of `items`, and what they refer to.
#[derive(Debug, Default)]
pub(crate) struct Layout<'a> {
    pub(crate) rows: Vec<Row<'a>>,
    pub(crate) extras: Vec<Extra>,
    pub(crate) pool: Pool,
}

impl<'a> Layout<'a> {
    pub(crate) fn new(items: &[Item<'a>]) -> Self {
        let mut layout = Self::default();
        for (number, item) in items.iter().enumerate() {
            for (element, entry) in item.entries.iter().enumerate() {
                layout.push(number, item, element, entry);
            }
        }
        layout
    }

    fn push(&mut self, number: usize, item: &Item<'a>, element: usize, entry: &'a Entry) {
        let constant = item.storage == Storage::Constant;
        let parts = item.storage == Storage::Parts;
        let place = match &entry.default {
            _ if parts => Place::Constant(0),
            Some(value) if constant => Place::Constant(self.constant(item, entry, value)),
            _ => Place::Field(number, element * item.kind.size()),
        };
        let slot = match self.detail(item, entry) {
            Some(detail) => {
                let address = entry.address;
                self.extras.push(Extra { address, place, detail });
                Slot::Extra(self.extras.len() - 1)
            }
            None => Slot::Place(place),
        };
        let sub = &entry.address.sub;
        self.rows.push(Row {
            entry,
            constant,
            parts,
            reads: item.reads.contains(sub),
            writes: item.writes.contains(sub),
            slot,
        });
    }

    fn constant(&mut self, item: &Item<'a>, entry: &Entry, value: &Value) -> usize {
        self.pool
            .place(stored(value, entry, item.kind), || entry.address.to_string())
    }

    /// What an extra row says of `entry`; `None` when it needs none.
    fn detail(&mut self, item: &Item<'a>, entry: &Entry) -> Option<usize> {
        match (item.kind.capacity(), item.storage) {
            (_, Storage::Parts) => None,
            (Some(capacity), Storage::Field) => Some(capacity),
            (Some(_), Storage::Constant) => {
                let value = entry.default.as_ref()?;
                Some(value.to_bytes(entry.data_type, None).len())
            }
            // Limits bind a client; what it cannot write needs none.
            (None, _) => {
                let limits = entry.access.writable().then(|| limits(entry, item.kind))??;
                Some(self.pool.place(limits, || format!("limits of {}", entry.address)))
            }
        }
    }
}

impl Row<'_> {
    /// The bits of the runtime's `Access` beside the access type itself.
    pub(crate) fn flags(&self) -> impl Iterator<Item = &'static str> + use<> {
        let Entry {
            access, pdo_mapping, ..
        } = *self.entry;
        let flags = [
            (pdo_mapping && !self.parts && sends(access), "TPDO"),
            (pdo_mapping && !self.parts && receives(access), "RPDO"),
            (matches!(self.slot, Slot::Extra(_)), "EXTRA"),
            (self.reads && !self.parts, "READ_HANDLER"),
            (self.writes && !self.parts, "WRITE_HANDLER"),
            (self.parts, "CONSTANT"),
            (self.parts, "PARTS"),
            (matches!(self.entry.default, Some(Value::NodeIdPlus(_))), "NODE_ID"),
            (is_counted(self.entry.address), "COUNTED"),
        ];
        flags.into_iter().filter(|(set, _)| *set).map(|(_, name)| name)
    }
}

/// Whether it is an element of the error history, of which there are as many as errors (CiA 301, 7.5.2.4).
fn is_counted(address: Address) -> bool {
    address.index == 0x1003 && address.sub != 0
}

/// Whether a mappable value with this access may be mapped into a TPDO (CiA 306-1, table for AccessType).
fn sends(access: AccessType) -> bool {
    !matches!(access, AccessType::Wo | AccessType::Rww)
}

/// Whether it may be mapped into an RPDO.
fn receives(access: AccessType) -> bool {
    matches!(access, AccessType::Wo | AccessType::Rw | AccessType::Rww)
}
