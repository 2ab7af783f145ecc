//! Naming objects in the builder.

use std::fmt;

use lexican_eds::ir::{Address, Dictionary, Entry, Object};

/// An object, or one value of it: `0x6003`, `(0x6003, 0)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Selector {
    /// Every value of the object with this index, but for a constant sub-index 0 that only counts the others.
    Object(u16),
    /// The value at this index and sub-index.
    Value(u16, u8),
}

impl Selector {
    /// Whether it means `entry` of `object`.
    pub(crate) fn selects(self, object: &Object, entry: &Entry) -> bool {
        match self {
            Self::Object(index) => index == object.index && !is_count(object, entry),
            Self::Value(index, sub) => Address::new(index, sub) == entry.address,
        }
    }

    /// The values that it means.
    pub(crate) fn values(self, dictionary: &Dictionary) -> impl Iterator<Item = &Entry> {
        let of_object = move |object: &Object, entry: &&Entry| self.selects(object, entry);
        let objects = dictionary.objects.iter();
        objects.flat_map(move |object| object.entries.iter().filter(move |entry| of_object(object, entry)))
    }

    /// The index.
    pub(crate) fn index(self) -> u16 {
        match self {
            Self::Object(index) | Self::Value(index, _) => index,
        }
    }
}

/// Whether `entry` is the sub-index 0 that says how many others there are, and does not change.
pub(crate) fn is_count(object: &Object, entry: &Entry) -> bool {
    // 1003h:00 counts the errors so far (CiA 301, 7.5.2.6).
    entry.address.sub == 0 && object.entries.len() > 1 && !entry.access.writable() && object.index != 0x1003
}

impl From<u16> for Selector {
    fn from(index: u16) -> Self {
        Self::Object(index)
    }
}

impl From<(u16, u8)> for Selector {
    fn from((index, sub): (u16, u8)) -> Self {
        Self::Value(index, sub)
    }
}

impl fmt::Display for Selector {
    /// `6003h`, `6003sub1`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Object(index) => write!(f, "{index:04X}h"),
            Self::Value(index, sub) => Address::new(index, sub).fmt(f),
        }
    }
}
