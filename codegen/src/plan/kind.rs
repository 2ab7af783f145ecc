//! What a value is in Rust.

use lexican_eds::ir::DataType;

/// The Rust side of a data type.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Kind {
    /// `Boolean` in the struct, `bool` for the application.
    Boolean,
    /// `i8` to `i64`; the odd widths stand in the next wider one.
    Signed(Width),
    /// `u8` to `u64`.
    Unsigned(Width),
    /// `f32`
    Real32,
    /// `f64`
    Real64,
    /// `TimeOfDay`, six bytes.
    Time,
    /// `VisibleString<N>`
    Visible(usize),
    /// `OctetString<N>`: OCTET_STRING, UNICODE_STRING, DOMAIN.
    Octets(usize),
}

/// The width of a Rust integer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Width {
    W8,
    W16,
    W32,
    W64,
}

impl Kind {
    /// The kind of a value of `data_type`; a string's has room for `capacity` bytes.
    pub(crate) fn new(data_type: DataType, capacity: usize) -> Self {
        match data_type {
            DataType::Boolean => Self::Boolean,
            DataType::Real32 => Self::Real32,
            DataType::Real64 => Self::Real64,
            DataType::TimeOfDay | DataType::TimeDifference => Self::Time,
            DataType::VisibleString => Self::Visible(capacity),
            DataType::OctetString | DataType::UnicodeString | DataType::Domain => Self::Octets(capacity),
            number if number.is_signed() => Self::Signed(Width::of(number)),
            number => Self::Unsigned(Width::of(number)),
        }
    }

    /// Bytes in the struct.
    pub(crate) fn size(self) -> usize {
        match self {
            Self::Boolean => 1,
            Self::Signed(width) | Self::Unsigned(width) => width.bytes(),
            Self::Real32 => 4,
            Self::Real64 => 8,
            Self::Time => 6,
            // A length of two bytes stands before the text.
            Self::Visible(capacity) | Self::Octets(capacity) => 2 + capacity,
        }
    }

    /// The alignment in the struct, on a target that aligns every number to its size.
    pub(crate) fn alignment(self) -> usize {
        match self {
            Self::Time | Self::Visible(_) | Self::Octets(_) => 1,
            number => number.size(),
        }
    }

    /// The capacity of a string.
    pub(crate) fn capacity(self) -> Option<usize> {
        match self {
            Self::Visible(capacity) | Self::Octets(capacity) => Some(capacity),
            _ => None,
        }
    }
}

impl Width {
    fn of(data_type: DataType) -> Self {
        match data_type.bytes() {
            Some(1) => Self::W8,
            Some(2) => Self::W16,
            Some(3 | 4) => Self::W32,
            _ => Self::W64,
        }
    }

    fn bytes(self) -> usize {
        match self {
            Self::W8 => 1,
            Self::W16 => 2,
            Self::W32 => 4,
            Self::W64 => 8,
        }
    }

    /// `8`, `16`, `32`, `64`.
    pub(crate) fn bits(self) -> usize {
        self.bytes() * 8
    }
}

/// The data types that have no fixed length.
pub(crate) fn is_string(data_type: DataType) -> bool {
    data_type.bits().is_none()
}
