//! One row of the table: eight bytes of flash for each value.

use super::DataType;
use crate::Address;

/// What may be done with a value, and where it stands: a set of bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Access(pub u16);

impl Access {
    /// A client may read it.
    pub const READ: Self = Self(0x0001);
    /// A client may write it.
    pub const WRITE: Self = Self(0x0002);
    /// It may be mapped into a TPDO.
    pub const TPDO: Self = Self(0x0004);
    /// It may be mapped into an RPDO.
    pub const RPDO: Self = Self(0x0008);
    /// It stands in [`Table::constants`](super::Table::constants), not among the values.
    pub const CONSTANT: Self = Self(0x0010);
    /// The entry's slot is the number of an [`Extra`]: the value is a string, or has limits.
    pub const EXTRA: Self = Self(0x0020);
    /// [`Device::before_read`](super::Device::before_read) is called before it is read.
    pub const READ_HANDLER: Self = Self(0x0040);
    /// [`Device::before_write`](super::Device::before_write) is called before it is written.
    pub const WRITE_HANDLER: Self = Self(0x0080);
    /// An integer whose default is a formula of `$NODEID`: the node-ID is added to it.
    pub const NODE_ID: Self = Self(0x0100);
    /// A string or DOMAIN of any length that the application gives and takes in parts
    /// ([`Device::read_part`](super::Device::read_part), [`Device::write_part`](super::Device::write_part)). The dictionary
    /// has no room for it, so it is [`Access::CONSTANT`] too, at any slot.
    pub const PARTS: Self = Self(0x0200);
    /// An element of an ARRAY whose sub-index 0 says how many there are at the moment: the others have no data. So is the
    /// error history (1003h).
    pub const COUNTED: Self = Self(0x0400);

    /// This and `other` together.
    #[must_use]
    pub const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether any of `other` is in this.
    pub(crate) const fn has_any(self, other: Self) -> bool {
        self.0 & other.0 != 0
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
    /// Offset of the value in [`Device::values`](super::Device::values) or [`Table::constants`](super::Table::constants)
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

    /// A row of the table, for a table made at compile time.
    ///
    /// # Panics
    /// At compile time, when `slot` is beyond 65,535.
    #[must_use]
    pub const fn new(index: u16, sub: u8, data_type: DataType, access: Access, slot: usize) -> Self {
        Self {
            slot: short(slot),
            index,
            sub,
            data_type,
            access,
        }
    }

    /// Index and sub-index.
    #[must_use]
    pub const fn address(self) -> Address {
        Address::new(self.index, self.sub)
    }
}

/// What an entry of eight bytes has no room for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extra {
    /// Offset of the value, as [`Entry::slot`] would be.
    pub slot: u16,
    /// Of a string its capacity in bytes (of a constant one its length).
    /// Of a number the offset of its two limits in [`Table::constants`](super::Table::constants): low, then high, each
    /// stored as a constant is. A number with only one limit has its type's least or greatest value as the other.
    pub detail: u16,
}

impl Extra {
    /// A row of [`Table::extras`](super::Table::extras), for a table made at compile time.
    ///
    /// # Panics
    /// At compile time, when a number is beyond 65,535.
    #[must_use]
    pub const fn new(slot: usize, detail: usize) -> Self {
        Self {
            slot: short(slot),
            detail: short(detail),
        }
    }
}

/// `offset` in 16 bits.
#[allow(clippy::cast_possible_truncation)] // The assertion before it.
const fn short(offset: usize) -> u16 {
    assert!(
        offset <= 0xFFFF,
        "a dictionary has 64 KiB of values and 64 KiB of constants"
    );
    offset as u16
}
