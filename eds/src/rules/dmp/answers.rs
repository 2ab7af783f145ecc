//! What the file declares beside what the device answered.

use crate::{
    dump::{Answer, Dump},
    ir::{Address, Dictionary, Entry, Object, ObjectCode},
};

/// An entry of the file with the bytes that the device answered for it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Answered<'a> {
    pub(super) object: &'a Object,
    pub(super) entry: &'a Entry,
    pub(super) bytes: &'a [u8],
}

impl Answered<'_> {
    /// Whether the bytes are as many as the data type has; always so for a string.
    pub(super) fn fits(&self) -> bool {
        let length = self.entry.data_type.bytes();
        length.is_none_or(|length| length == self.bytes.len())
    }

    /// As a message names it, see [`named`].
    pub(super) fn named(&self) -> String {
        named(self.object, self.entry.address)
    }
}

/// The entries that the file says can be read and for which the device answered with bytes.
pub(super) fn answered<'a>(dictionary: &'a Dictionary, dump: &'a Dump) -> impl Iterator<Item = Answered<'a>> {
    entries(dictionary)
        .filter(|(_, entry)| entry.access.readable())
        .filter_map(|(object, entry)| {
            let bytes = dump.value(entry.address)?;
            Some(Answered { object, entry, bytes })
        })
}

/// The entries for which the device answered anything.
pub(super) fn asked<'a>(
    dictionary: &'a Dictionary,
    dump: &'a Dump,
) -> impl Iterator<Item = (&'a Object, &'a Entry, &'a Answer)> {
    entries(dictionary).filter_map(|(object, entry)| Some((object, entry, dump.answer(entry.address)?)))
}

fn entries(dictionary: &Dictionary) -> impl Iterator<Item = (&Object, &Entry)> {
    let objects = dictionary.objects.iter();
    objects.flat_map(|object| object.entries.iter().map(move |entry| (object, entry)))
}

/// As a message names an address: `1017h` of an object without sub-indices, else `1018sub1`.
pub(super) fn named(object: &Object, address: Address) -> String {
    if has_sub_indices(object) {
        return address.to_string();
    }
    format!("{:04X}h", address.index)
}

/// Whether the object is an array or a record: its sub-index 0 says which sub-index is the highest.
pub(super) const fn has_sub_indices(object: &Object) -> bool {
    matches!(
        object.code,
        ObjectCode::Array | ObjectCode::Record | ObjectCode::DefStruct
    )
}

/// Whether the address is an error of 1003h that has not happened yet: it may be answered in any way.
pub(super) fn is_empty_error(address: Address, dump: &Dump) -> bool {
    let errors = dump.value(Address::new(0x1003, 0));
    let number = errors.and_then(<[u8]>::first).copied().unwrap_or(0);
    address.index == 0x1003 && address.sub > number
}
