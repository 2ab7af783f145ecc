//! What is generated for an object: a field or a constant for each value, or one for all elements of an array.

use lexican_eds::ir::{Address, Dictionary, Entry, Object, ObjectCode};

use super::{Kind, Options, Storage};
use crate::name::{Named, unique_names};

/// A field or a constant.
#[derive(Clone, Debug)]
pub(crate) struct Item<'a> {
    pub(crate) object: &'a Object,
    /// The one value; of an array its elements, sub-index 1 and up without a gap.
    pub(crate) entries: &'a [Entry],
    pub(crate) is_array: bool,
    pub(crate) kind: Kind,
    pub(crate) storage: Storage,
    /// In snake case, not yet safe from keywords.
    pub(crate) name: String,
    /// The sub-indices that the application answers for when a client reads them.
    pub(crate) reads: Vec<u8>,
    /// The sub-indices that the application answers for when a client writes them.
    pub(crate) writes: Vec<u8>,
}

impl<'a> Item<'a> {
    /// What is generated for `dictionary`, in the order of addresses.
    pub(crate) fn all(dictionary: &'a Dictionary, options: &Options) -> Vec<Self> {
        let objects = dictionary.objects.iter();
        let mut items: Vec<Self> = objects.flat_map(|object| Self::of_object(object, options)).collect();
        let named: Vec<Named<'_>> = items.iter().map(Self::named).collect();
        for (item, name) in items.iter_mut().zip(unique_names(&named)) {
            item.name = name;
        }
        items
    }

    fn of_object(object: &'a Object, options: &Options) -> Vec<Self> {
        let elements = object
            .entries
            .get(1..)
            .filter(|elements| is_array(object, elements, options));
        let single = match elements {
            Some(_) => object.entries.get(..1),
            None => object.entries.get(..),
        };
        let singles = single.unwrap_or_default().chunks(1);
        let items = singles.map(|entry| Self::new(object, entry, false, options));
        let array = elements.map(|elements| Self::new(object, elements, true, options));
        items.chain(array).collect()
    }

    fn new(object: &'a Object, entries: &'a [Entry], is_array: bool, options: &Options) -> Self {
        let subs = |wanted: fn(&Options, &Object, &Entry) -> bool| {
            let entries = entries.iter().filter(|entry| wanted(options, object, entry));
            entries.map(|entry| entry.address.sub).collect::<Vec<u8>>()
        };
        let (mut reads, mut writes) = (subs(Options::handles_read), subs(Options::handles_write));
        let handled = !reads.is_empty() || !writes.is_empty();
        let capacity = entries.iter().map(|entry| options.capacity(object, entry)).max();
        let kind_of = |entry: &Entry| Kind::new(entry.data_type, capacity.unwrap_or_default());
        let storage = entries
            .first()
            .map_or(Storage::Field, |entry| Storage::of(object, entry, handled, options));
        if storage == Storage::Parts {
            // Nobody else could answer in the other direction.
            reads = subs(|_, _, entry| entry.access.readable());
            writes = subs(|_, _, entry| entry.access.writable());
        }
        Self {
            object,
            entries,
            is_array,
            kind: entries.first().map_or(Kind::Unsigned(super::Width::W8), kind_of),
            storage,
            name: String::new(),
            reads,
            writes,
        }
    }

    /// The address of the first value.
    pub(crate) fn address(&self) -> Address {
        self.entries
            .first()
            .map_or(Address::new(self.object.index, 0), |entry| entry.address)
    }

    /// Bytes in the struct.
    pub(crate) fn size(&self) -> usize {
        self.kind.size() * self.entries.len()
    }

    /// Whether all its bytes are 0 after power-on.
    pub(crate) fn is_zero(&self) -> bool {
        let bytes = |entry: &Entry| {
            entry
                .default
                .as_ref()
                .map(|value| value.to_bytes(entry.data_type, None))
        };
        // A string has its length beside its bytes.
        let is_zero = |bytes: Vec<u8>| {
            bytes.iter().all(|&byte| byte == 0) && (self.kind.capacity().is_none() || bytes.is_empty())
        };
        self.entries.iter().filter_map(bytes).all(is_zero)
    }

    fn named(&self) -> Named<'a> {
        let alone = self.is_array || self.object.entries.len() == 1 && self.address().sub == 0;
        Named {
            object: self.object,
            address: self.address(),
            sub_name: self.entries.first().filter(|_| !alone).map(|entry| entry.name.as_str()),
        }
    }
}

/// Whether `elements`, all but the first value of `object`, are alike and without a gap: one field `[T; N]`.
fn is_array(object: &Object, elements: &[Entry], options: &Options) -> bool {
    let Some(first) = elements.first() else { return false };
    let handled = elements.iter().any(|entry| options.handles(object, entry));
    let storage = Storage::of(object, first, handled, options);
    let alike = |(sub, entry): (u8, &Entry)| {
        entry.address.sub == sub
            && entry.data_type == first.data_type
            && entry.access == first.access
            && Storage::of(object, entry, handled, options) == storage
    };
    is_list(object)
        && object.entries.first().is_some_and(|entry| entry.address.sub == 0)
        && (1..=u8::MAX).zip(elements).all(alike)
}

/// Whether the values from sub-index 1 on are many of the same by the standard: of an ARRAY, and of a PDO mapping, which
/// is a RECORD only by its name (CiA 301, 7.5.2.36 and 7.5.2.38).
fn is_list(object: &Object) -> bool {
    object.code == ObjectCode::Array || matches!(object.index, 0x1600..=0x17FF | 0x1A00..=0x1BFF)
}
