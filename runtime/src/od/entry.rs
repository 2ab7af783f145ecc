//! One row of the table: eight bytes of flash for each value.

use super::DataType;

/// What may be done with a value, a set of bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Access(pub u8);

impl Access {
    /// A client may read it.
    pub const READ: Self = Self(0x01);
    /// A client may write it.
    pub const WRITE: Self = Self(0x02);
    /// It may be mapped into a TPDO.
    pub const TPDO: Self = Self(0x04);
    /// It may be mapped into an RPDO.
    pub const RPDO: Self = Self(0x08);
    /// It stands in [`Table::constants`](super::Table::constants), not among the values.
    pub const CONSTANT: Self = Self(0x10);
    /// The entry's slot is the number of an [`Extra`]: the value is a string, or has limits.
    pub const EXTRA: Self = Self(0x20);
    /// [`Device::before_read`](super::Device::before_read) is called before it is read.
    pub const READ_HANDLER: Self = Self(0x40);
    /// [`Device::before_write`](super::Device::before_write) is called before it is written.
    pub const WRITE_HANDLER: Self = Self(0x80);

    /// This and `other` together.
    #[must_use]
    pub const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether all of `other` is in this.
    #[must_use]
    pub const fn has(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }
}

/// A value of the dictionary: where it stands and what it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Offset of the value in [`Device::Values`](super::Device::Values) or [`Table::constants`](super::Table::constants)
    /// in bytes; with [`Access::EXTRA`] the number of its [`Extra`].
    pub slot: u16,
    /// The object's index.
    pub index: u16,
    /// The sub-index.
    pub sub: u8,
    /// The data type.
    pub data_type: DataType,
    /// What may be done with it.
    pub access: Access,
}

impl Entry {
    /// Stands where no object does.
    pub const EMPTY: Self = Self::new(0, 0, DataType(0), Access(0), 0);

    /// A row of the table.
    #[must_use]
    pub const fn new(index: u16, sub: u8, data_type: DataType, access: Access, slot: u16) -> Self {
        Self {
            slot,
            index,
            sub,
            data_type,
            access,
        }
    }
}

/// What an entry of eight bytes has no room for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extra {
    /// Offset of the value, as [`Entry::slot`] would be.
    pub slot: u16,
    /// Of a string its capacity in bytes (of a constant one its length).
    /// Of a number the offset of its two limits in [`Table::constants`](super::Table::constants), low then high, each
    /// little-endian and as long as the data type is on the bus.
    pub detail: u16,
}
