//! The data types of CiA 301, by their index in the object dictionary.

/// A static data type, its number being its index in the dictionary (CiA 301, table 44), `0x01..=0x1B`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DataType(pub u8);

impl DataType {
    /// 0001h, one byte on the bus, 0 or 1.
    pub const BOOLEAN: Self = Self(0x01);
    /// 0002h
    pub const INTEGER8: Self = Self(0x02);
    /// 0003h
    pub const INTEGER16: Self = Self(0x03);
    /// 0004h
    pub const INTEGER32: Self = Self(0x04);
    /// 0005h
    pub const UNSIGNED8: Self = Self(0x05);
    /// 0006h
    pub const UNSIGNED16: Self = Self(0x06);
    /// 0007h
    pub const UNSIGNED32: Self = Self(0x07);
    /// 0008h, IEEE 754 single precision.
    pub const REAL32: Self = Self(0x08);
    /// 0009h
    pub const VISIBLE_STRING: Self = Self(0x09);
    /// 000Ah
    pub const OCTET_STRING: Self = Self(0x0A);
    /// 000Bh, UTF-16 code units, little-endian.
    pub const UNICODE_STRING: Self = Self(0x0B);
    /// 000Ch, 6 bytes: milliseconds after midnight (28 bits), days since 1984-01-01 (16 bits).
    pub const TIME_OF_DAY: Self = Self(0x0C);
    /// 000Dh, 6 bytes: milliseconds (28 bits), days (16 bits).
    pub const TIME_DIFFERENCE: Self = Self(0x0D);
    /// 000Fh
    pub const DOMAIN: Self = Self(0x0F);
    /// 0010h, 3 bytes on the bus, an `i32` in the dictionary.
    pub const INTEGER24: Self = Self(0x10);
    /// 0011h, IEEE 754 double precision.
    pub const REAL64: Self = Self(0x11);
    /// 0012h, 5 bytes on the bus, an `i64` in the dictionary.
    pub const INTEGER40: Self = Self(0x12);
    /// 0013h
    pub const INTEGER48: Self = Self(0x13);
    /// 0014h
    pub const INTEGER56: Self = Self(0x14);
    /// 0015h
    pub const INTEGER64: Self = Self(0x15);
    /// 0016h, 3 bytes on the bus, a `u32` in the dictionary.
    pub const UNSIGNED24: Self = Self(0x16);
    /// 0018h, 5 bytes on the bus, a `u64` in the dictionary.
    pub const UNSIGNED40: Self = Self(0x18);
    /// 0019h
    pub const UNSIGNED48: Self = Self(0x19);
    /// 001Ah
    pub const UNSIGNED56: Self = Self(0x1A);
    /// 001Bh
    pub const UNSIGNED64: Self = Self(0x1B);
}

/// Bytes on the bus of each type by its number; 0 for strings, domains and numbers without a type.
const LENGTHS: [u8; 32] = [
    0, 1, 1, 2, 4, 1, 2, 4, 4, 0, 0, 0, 6, 6, 0, 0, // up to 000Fh
    3, 8, 5, 6, 7, 8, 3, 0, 5, 6, 7, 8, 0, 0, 0, 0, // up to 001Fh
];

/// Bytes in the dictionary's struct of each type by its number.
const WIDTHS: [u8; 32] = [
    0, 1, 1, 2, 4, 1, 2, 4, 4, 0, 0, 0, 6, 6, 0, 0, // up to 000Fh
    4, 8, 8, 8, 8, 8, 4, 0, 8, 8, 8, 8, 0, 0, 0, 0, // up to 001Fh
];

impl DataType {
    /// Bytes that a value has on the bus, 1 to 8; 0 for a type without a fixed length (strings, DOMAIN).
    #[must_use]
    pub const fn length(self) -> usize {
        LENGTHS[(self.0 & 0x1F) as usize] as usize
    }

    /// Bytes that a value takes in the dictionary's struct: 24 bits widened to 4 bytes, 40 to 56 bits to 8; else
    /// [`DataType::length`].
    #[must_use]
    pub const fn width(self) -> usize {
        WIDTHS[(self.0 & 0x1F) as usize] as usize
    }

    /// Whether it is INTEGER8 to INTEGER64.
    #[must_use]
    pub const fn is_signed(self) -> bool {
        matches!(self.0, 0x02..=0x04 | 0x10 | 0x12..=0x15)
    }

    /// Whether it is REAL32 or REAL64.
    #[must_use]
    pub const fn is_real(self) -> bool {
        matches!(self, Self::REAL32 | Self::REAL64)
    }
}
