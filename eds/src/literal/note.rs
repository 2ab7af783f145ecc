//! How a value is written, and why one cannot be read.

use std::fmt;

/// Something unusual in the way a value is written. The value is known all the same; other readers may fail on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
#[non_exhaustive]
pub enum Note {
    /// A comment follows the value: `0x0007 # UNSIGNED32`.
    TrailingComment,
    /// A hex number of a signed type means a negative value by its top bit: `0x80000000` of INTEGER32.
    TwosComplement,
    /// A hex number has more digits than the type has: `0x00000000` of UNSIGNED16.
    WideHex,
    /// A leading 0 makes the number octal, and decimal reading would give another value: `010`.
    Octal,
    /// A suffix of C: `0x10LL`, `1.0f`.
    Suffix,
    /// `$NodeId`, `$nodeid`: not spelled `$NODEID`.
    NodeIdCase,
    /// `NODEID` without its `$`.
    NodeIdWithoutDollar,
    /// A text in double quotes, which are left out.
    Quoted,
    /// A real number given as the pattern of its bits: `0x3F800000`.
    RealAsBits,
    /// A word that the standard has in small letters: `RO`.
    LetterCase,
    /// `R` for `ro`, `W` for `wo`.
    Abbreviation,
    /// A name in place of its number: `VAR`, `UNSIGNED32`.
    Name,
}

impl Note {
    const ALL: [Self; 12] = [
        Self::TrailingComment,
        Self::TwosComplement,
        Self::WideHex,
        Self::Octal,
        Self::Suffix,
        Self::NodeIdCase,
        Self::NodeIdWithoutDollar,
        Self::Quoted,
        Self::RealAsBits,
        Self::LetterCase,
        Self::Abbreviation,
        Self::Name,
    ];
}

/// A set of [`Note`]s.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub struct Notes(u16);

impl Notes {
    /// Nothing unusual.
    pub const NONE: Self = Self(0);

    /// Puts `note` into the set.
    pub const fn add(&mut self, note: Note) {
        self.0 |= 1 << note as u8;
    }

    /// The notes of both.
    #[must_use]
    pub const fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether nothing is unusual.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Whether `note` is in the set.
    #[must_use]
    pub const fn contains(self, note: Note) -> bool {
        self.0 & (1 << note as u8) != 0
    }

    /// The notes, in the order of [`Note`].
    pub fn iter(self) -> impl Iterator<Item = Note> {
        Note::ALL.into_iter().filter(move |&note| self.contains(note))
    }
}

impl From<Note> for Notes {
    fn from(note: Note) -> Self {
        Self(1 << note as u8)
    }
}

impl fmt::Debug for Notes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.iter()).finish()
    }
}

/// Why a value cannot be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Fault {
    /// Not an integer number.
    NotANumber,
    /// A leading 0 makes it octal, but it has an 8 or a 9.
    NotOctal,
    /// A number that its type cannot hold.
    OutOfRange,
    /// A formula with a name other than `$NODEID`: `$MY_NODE_ID+0x200`.
    UnknownVariable,
    /// A `$NODEID` formula of a type that is not an integer.
    MisplacedFormula,
    /// Not a real number.
    NotAReal,
    /// A hex number of a real type with fewer digits than the type has: its bits, or a value?
    AmbiguousReal,
    /// Not pairs of hex digits.
    NotBytes,
    /// Not `days milliseconds`.
    NotATime,
    /// Not one of the words that the keyword takes.
    UnknownWord,
}
