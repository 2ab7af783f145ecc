//! The constants in flash, equal ones shared.

use std::collections::BTreeMap;

use lexican_eds::ir::{Entry, Value};

use super::Kind;

/// A byte array, put together of labelled pieces.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pool {
    /// What it is made of, and for what each piece was first needed.
    pub(crate) pieces: Vec<(Vec<u8>, String)>,
    places: BTreeMap<Vec<u8>, usize>,
    length: usize,
}

impl Pool {
    /// The offset of `bytes`, which are put in if they are not there yet.
    pub(crate) fn place(&mut self, bytes: Vec<u8>, label: impl FnOnce() -> String) -> usize {
        if bytes.is_empty() {
            return 0;
        }
        if let Some(&place) = self.places.get(&bytes) {
            return place;
        }
        let place = self.length;
        self.length += bytes.len();
        self.places.insert(bytes.clone(), place);
        self.pieces.push((bytes, label()));
        place
    }

    /// How many bytes there are.
    pub(crate) fn len(&self) -> usize {
        self.length
    }
}

/// The bytes of a constant: a string's as they are, a number's little-endian and as wide as in the struct.
pub(crate) fn stored(value: &Value, entry: &Entry, kind: Kind) -> Vec<u8> {
    let mut bytes = value.to_bytes(entry.data_type, None);
    if kind.capacity().is_none() {
        let negative = entry.data_type.is_signed() && bytes.last().is_some_and(|last| last & 0x80 != 0);
        bytes.resize(kind.size(), if negative { 0xFF } else { 0 });
    }
    bytes
}
