//! Which kinds of numbers a dictionary has that cost code of their own.

use super::{Access, DataType, Row};

/// A set of kinds of numbers that not every dictionary has.
///
/// A generated device says its own in [`Device::NUMBERS`](super::Device::NUMBERS): a constant, so that what none of its
/// numbers needs is not compiled in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NumberSet(u8);

impl NumberSet {
    /// Only those of up to 32 bits, without limits, that Rust has a type for.
    pub const PLAIN: Self = Self(0x00);
    /// Some of more than four bytes.
    pub const LONG: Self = Self(0x01);
    /// Some that stand in the dictionary wider than they are: of 24, 40, 48 or 56 bits.
    pub const WIDENED: Self = Self(0x02);
    /// Some with limits.
    pub const LIMITED: Self = Self(0x04);
    /// Some REALs.
    pub const REAL: Self = Self(0x08);
    /// All of them, for a device whose dictionary is known at run time only.
    pub const ALL: Self = Self(0x0F);

    /// The kinds among these rows.
    #[must_use]
    pub const fn of(rows: &[Row]) -> Self {
        let mut set = Self::PLAIN;
        let mut row = 0;
        while row < rows.len() {
            let entry = rows[row].entry(0);
            set = set.with(Self::of_value(entry.data_type, entry.access));
            row += 1;
        }
        set
    }

    const fn of_value(data_type: DataType, access: Access) -> Self {
        let kinds = [
            (data_type.length() > 4, Self::LONG),
            (data_type.width() != data_type.length(), Self::WIDENED),
            (data_type.length() != 0 && access.has(Access::EXTRA), Self::LIMITED),
            (data_type.is_real(), Self::REAL),
        ];
        let mut set = Self::PLAIN;
        let mut kind = 0;
        while kind < kinds.len() {
            if kinds[kind].0 {
                set = set.with(kinds[kind].1);
            }
            kind += 1;
        }
        set
    }

    /// These and `others`.
    #[must_use]
    pub const fn with(self, others: Self) -> Self {
        Self(self.0 | others.0)
    }

    /// Whether any of `others` is in it.
    #[must_use]
    pub const fn has(self, others: Self) -> bool {
        self.0 & others.0 != 0
    }
}

#[cfg(test)]
mod tests {
    use super::{NumberSet, Row};
    use crate::od::{Access, DataType};

    #[test]
    fn a_kind_is_in_the_set_when_a_number_is_of_it() {
        let set = |data_type, access| NumberSet::of(&[Row::value(0x2000, 0, data_type, access, 0)]);
        assert_eq!(set(DataType::UNSIGNED32, Access::READ), NumberSet::PLAIN);
        assert_eq!(set(DataType::VISIBLE_STRING, Access::EXTRA), NumberSet::PLAIN);
        assert_eq!(set(DataType::INTEGER8, Access::EXTRA), NumberSet::LIMITED);
        assert_eq!(set(DataType::UNSIGNED24, Access::READ), NumberSet::WIDENED);
        assert_eq!(
            set(DataType::INTEGER40, Access::READ),
            NumberSet::WIDENED.with(NumberSet::LONG)
        );
        assert_eq!(
            set(DataType::REAL64, Access::READ),
            NumberSet::REAL.with(NumberSet::LONG)
        );
    }
}
