//! The rows that a generated table is made of at compile time.

use super::{Access, DataType, Entry};

/// A row of a generated table, before [`place`](super::place) lays the table out: a value, or elements of an ARRAY
/// that are alike and stand one behind the other.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    first: Entry,
    last_sub: u8,
}

impl Row {
    /// The row of one value; `slot` is as [`Entry::slot`].
    ///
    /// # Panics
    /// At compile time, when `slot` is beyond 65,535.
    #[must_use]
    pub const fn value(index: u16, sub: u8, data_type: DataType, access: Access, slot: usize) -> Self {
        Self::elements(index, sub, sub, data_type, access, slot)
    }

    /// The row of the values from `first_sub` to `last_sub`; `slot` is the first one's, and the others' follow it:
    /// offsets by the type's width, numbers of [`Extra`](super::Extra)s by one.
    ///
    /// # Panics
    /// At compile time, when a slot is beyond 65,535.
    #[must_use]
    pub const fn elements(
        index: u16,
        first_sub: u8,
        last_sub: u8,
        data_type: DataType,
        access: Access,
        slot: usize,
    ) -> Self {
        Self {
            first: Entry::new(index, first_sub, data_type, access, slot),
            last_sub,
        }
    }

    /// The object's index.
    pub(super) const fn index(&self) -> u16 {
        self.first.index
    }

    /// What may be done with its values.
    pub(super) const fn access(&self) -> Access {
        self.first.access
    }

    /// How many values it stands for.
    pub(super) const fn values(&self) -> u8 {
        self.last_sub - self.first.sub + 1
    }

    /// The entry of its value number `nth`, from 0 on.
    pub(super) const fn entry(&self, nth: u8) -> Entry {
        let step = if self.first.access.has(Access::EXTRA) {
            1
        } else {
            self.first.data_type.width()
        };
        let slot = self.first.slot as usize + nth as usize * step;
        Entry::new(
            self.first.index,
            self.first.sub + nth,
            self.first.data_type,
            self.first.access,
            slot,
        )
    }
}
