//! Writing a new image: what stays of the old one, and what is saved.

use super::{
    image::{Image, Reader, Record, Settings, Writer, SETTINGS},
    newest,
    parameters::VERIFY_CONFIGURATION,
    Failed, Group, Storage,
};
use crate::{
    od::{self, Device, Entry, Value},
    Address,
};

/// What is to be other in the new image.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Change {
    /// The group has the values of now.
    Save(Group),
    /// The group has none.
    Forget(Group),
    /// LSS has these.
    Set(Settings),
}

impl Change {
    /// Whether what is stored at `address`, a value of `group`, stays.
    fn keeps(self, address: Address, group: Group) -> bool {
        match self {
            Self::Save(saved) => !saved.includes(group),
            // What was verified is not what will be there.
            Self::Forget(forgotten) => !forgotten.includes(group) && address.index != VERIFY_CONFIGURATION,
            Self::Set(_) => true,
        }
    }
}

/// Writes a new image, and reads it again.
pub(crate) fn change<D: Device>(device: &mut D, change: Change) -> Result<(), Failed> {
    let old = newest(device);
    let storage = device.storage().ok_or(Failed)?;
    let mut writer = Writer::begin(storage, old);
    if let Change::Set(settings) = change {
        // The first record, so that it is found soon.
        let bytes = settings.bytes();
        writer.record(storage, SETTINGS, bytes.len());
        writer.put(storage, &bytes);
    }
    if let Some(old) = old {
        copy(device, &mut writer, old, change);
    }
    if let Change::Save(group) = change {
        save(device, &mut writer, group);
    }
    let new = writer.end(device.storage().ok_or(Failed)?)?;
    if newest(device) == Some(new) {
        Ok(())
    } else {
        Err(Failed)
    }
}

/// How many bytes an image has that holds all that may be stored.
pub(super) fn room<D: Device>(device: &mut D) -> usize {
    let settings = Record::HEAD + 2;
    let mut room = Record::AROUND + settings;
    for place in 0..device.table().entries.len() {
        if let Some((entry, _)) = stored(device, place) {
            room += Record::HEAD + od::capacity(device, entry);
        }
    }
    room
}

/// What stays of the old image. Objects that are not there any more do not.
fn copy<D: Device>(device: &mut D, writer: &mut Writer, old: Image, change: Change) {
    let mut reader = Reader::of(old);
    while let Some(Record { address, length }) = device.storage().and_then(|storage| reader.record(storage)) {
        let stays = match address {
            SETTINGS => !matches!(change, Change::Set(_)),
            address => group_of(device, address).is_some_and(|group| change.keeps(address, group)),
        };
        let Some(storage) = device.storage() else { return };
        if !stays {
            reader.skip(storage, length);
            continue;
        }
        writer.record(storage, address, length);
        for _ in 0..length {
            let mut byte = [0];
            reader.fill(storage, &mut byte);
            writer.put(storage, &byte);
        }
    }
}

/// The group's values of now.
fn save<D: Device>(device: &mut D, writer: &mut Writer, saved: Group) {
    for place in 0..device.table().entries.len() {
        if let Some((entry, group)) = stored(device, place) {
            if saved.includes(group) {
                save_value(device, writer, entry);
            }
        }
    }
}

/// Byte by byte, as the value and the storage are both the device's.
fn save_value<D: Device>(device: &mut D, writer: &mut Writer, entry: Entry) {
    let length = match od::load(device, entry) {
        Ok(Value::Bytes(bytes)) => bytes.len(),
        Ok(Value::Number { data_type, .. }) => data_type.length(),
        Err(_) => return,
    };
    let Some(storage) = device.storage() else { return };
    writer.record(storage, entry.address(), length);
    for nth in 0..length {
        let byte = match od::load(device, entry) {
            Ok(Value::Bytes(bytes)) => bytes.get(nth).copied(),
            Ok(Value::Number { bits, .. }) => bits.to_le_bytes().get(nth).copied(),
            Err(_) => None,
        };
        if let Some(storage) = device.storage() {
            writer.put(storage, &[byte.unwrap_or(0)]);
        }
    }
}

/// The entry in that place of the table and its group, if it is stored.
fn stored<D: Device>(device: &mut D, place: usize) -> Option<(Entry, Group)> {
    let entry = device.table().entries.get(place).copied()?;
    let group = device.storage()?.group(entry).filter(|_| entry.data_type.0 != 0)?;
    Some((entry, group))
}

/// The group of the value at `address`, if it is stored.
pub(super) fn group_of<D: Device>(device: &mut D, address: Address) -> Option<Group> {
    let entry = device.table().find(address)?;
    device.storage()?.group(entry)
}
