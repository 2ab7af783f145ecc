//! A value on its way between the bus and the dictionary.

use super::{DataType, TimeOfDay};

/// A value as a service reads or writes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Value<'a> {
    /// A value of fixed length.
    Number {
        /// Its bits: the low [`DataType::length`] bytes are what goes on the bus, the low [`DataType::width`] bytes what
        /// stands in the dictionary. Higher ones mean nothing.
        bits: u64,
        /// The data type.
        data_type: DataType,
    },
    /// A string or DOMAIN.
    Bytes(&'a [u8]),
}

/// The conversions that generated code calls with the data type of the object. Asked for another type than the value
/// has, they give what the bits say in it; of bytes, 0.
#[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap)] // The value has the type that is asked for.
impl<'a> Value<'a> {
    /// The bits of a number; 0 for bytes.
    #[must_use]
    pub const fn bits(self) -> u64 {
        match self {
            Self::Number { bits, .. } => bits,
            Self::Bytes(_) => 0,
        }
    }

    /// BOOLEAN
    #[must_use]
    pub const fn to_bool(self) -> bool {
        self.bits() != 0
    }

    /// UNSIGNED8
    #[must_use]
    pub const fn to_u8(self) -> u8 {
        self.bits() as u8
    }

    /// UNSIGNED16
    #[must_use]
    pub const fn to_u16(self) -> u16 {
        self.bits() as u16
    }

    /// UNSIGNED24 and UNSIGNED32
    #[must_use]
    pub const fn to_u32(self) -> u32 {
        self.bits() as u32
    }

    /// UNSIGNED40 to UNSIGNED64
    #[must_use]
    pub const fn to_u64(self) -> u64 {
        self.bits()
    }

    /// INTEGER8
    #[must_use]
    pub const fn to_i8(self) -> i8 {
        self.bits() as i8
    }

    /// INTEGER16
    #[must_use]
    pub const fn to_i16(self) -> i16 {
        self.bits() as i16
    }

    /// INTEGER24 and INTEGER32
    #[must_use]
    pub const fn to_i32(self) -> i32 {
        self.bits() as i32
    }

    /// INTEGER40 to INTEGER64
    #[must_use]
    pub const fn to_i64(self) -> i64 {
        self.bits() as i64
    }

    /// REAL32
    #[must_use]
    pub fn to_f32(self) -> f32 {
        f32::from_bits(self.to_u32())
    }

    /// REAL64
    #[must_use]
    pub fn to_f64(self) -> f64 {
        f64::from_bits(self.bits())
    }

    /// TIME_OF_DAY and TIME_DIFFERENCE
    #[must_use]
    pub const fn to_time(self) -> TimeOfDay {
        TimeOfDay::new((self.bits() >> 32) as u16, self.bits() as u32)
    }

    /// Strings and DOMAIN; empty for a number.
    #[must_use]
    pub const fn to_bytes(self) -> &'a [u8] {
        match self {
            Self::Number { .. } => &[],
            Self::Bytes(bytes) => bytes,
        }
    }
}
