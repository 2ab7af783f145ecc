//! What the builder was told.

use lexican_eds::ir::{DataType, Entry, Object};

use super::kind::is_string;
use crate::selector::Selector;

/// The room of a string for which neither the file nor the builder gives one, in bytes.
const DEFAULT_CAPACITY: usize = 32;

/// The builder's settings that decide what is generated.
#[derive(Clone, Debug, Default)]
pub(crate) struct Options {
    /// What the application answers for when a client reads it.
    pub(crate) reads: Vec<Selector>,
    /// What the application answers for when a client writes it.
    pub(crate) writes: Vec<Selector>,
    /// What the application gives and takes in parts, besides the DOMAINs that it answers for.
    pub(crate) streams: Vec<Selector>,
    /// The room of strings, in bytes; the last word counts.
    pub(crate) capacities: Vec<(Selector, usize)>,
}

impl Options {
    /// Whether the application answers for `entry`.
    pub(crate) fn handles(&self, object: &Object, entry: &Entry) -> bool {
        self.handles_read(object, entry) || self.handles_write(object, entry)
    }

    /// Whether the application answers when a client reads `entry`.
    pub(crate) fn handles_read(&self, object: &Object, entry: &Entry) -> bool {
        entry.access.readable() && self.reads.iter().any(|selector| selector.selects(object, entry))
    }

    /// Whether the application answers when a client writes `entry`.
    pub(crate) fn handles_write(&self, object: &Object, entry: &Entry) -> bool {
        entry.access.writable() && self.writes.iter().any(|selector| selector.selects(object, entry))
    }

    /// Whether `entry` has no room in the dictionary, as the application gives and takes it in parts; `handled` when the
    /// application answers for it.
    pub(crate) fn in_parts(&self, object: &Object, entry: &Entry, handled: bool) -> bool {
        let streamed = self.streams.iter().any(|selector| selector.selects(object, entry));
        handled && entry.data_type == DataType::Domain || streamed && is_string(entry.data_type)
    }

    /// The room of `entry`, if it is a string: what the builder says, else the length of its default.
    pub(crate) fn capacity(&self, object: &Object, entry: &Entry) -> usize {
        let mut told = self.capacities.iter().rev();
        let told = told
            .find(|(selector, _)| selector.selects(object, entry))
            .map(|&(_, capacity)| capacity);
        let default = || {
            entry
                .default
                .as_ref()
                .map(|value| value.to_bytes(entry.data_type, None).len())
        };
        told.or_else(|| default().filter(|&length| length > 0))
            .unwrap_or(DEFAULT_CAPACITY)
    }
}
