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
    let mut writer = Writer::begin(device.storage().ok_or(Failed)?, old)?;
    if let Change::Set(settings) = change {
        set(device, &mut writer, settings)?;
    }
    if let Some(old) = old {
        copy(device, &mut writer, old, change)?;
    }
    if let Change::Save(group) = change {
        save(device, &mut writer, group)?;
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

/// What LSS has configured. It is the first record, so that it is found soon.
fn set<D: Device>(device: &mut D, writer: &mut Writer, settings: Settings) -> Result<(), Failed> {
    let storage = device.storage().ok_or(Failed)?;
    let bytes = settings.bytes();
    writer.record(storage, SETTINGS, bytes.len())?;
    writer.put(storage, &bytes)
}

/// What stays of the old image. Objects that are not there any more do not.
fn copy<D: Device>(device: &mut D, writer: &mut Writer, old: Image, change: Change) -> Result<(), Failed> {
    let mut reader = Reader::of(old);
    loop {
        let record = reader.record(device.storage().ok_or(Failed)?).ok_or(Failed)?;
        if record.is_end() {
            return Ok(());
        }
        let Record { address, length } = record;
        let stays = match address {
            SETTINGS => !matches!(change, Change::Set(_)),
            address => group_of(device, address).is_some_and(|group| change.keeps(address, group)),
        };
        let storage = device.storage().ok_or(Failed)?;
        if stays {
            writer.record(storage, address, length)?;
        }
        for _ in 0..length {
            let mut byte = [0];
            reader.fill(storage, &mut byte).ok_or(Failed)?;
            if stays {
                writer.put(storage, &byte)?;
            }
        }
    }
}

/// The group's values of now.
fn save<D: Device>(device: &mut D, writer: &mut Writer, saved: Group) -> Result<(), Failed> {
    for place in 0..device.table().entries.len() {
        if let Some((entry, group)) = stored(device, place) {
            if saved.includes(group) {
                save_value(device, writer, entry)?;
            }
        }
    }
    Ok(())
}

fn save_value<D: Device>(device: &mut D, writer: &mut Writer, entry: Entry) -> Result<(), Failed> {
    let (length, bits) = match od::load(device, entry) {
        Ok(Value::Number { bits, .. }) => (entry.data_type.length(), bits),
        Ok(Value::Bytes(bytes)) => (bytes.len(), 0),
        Err(_) => return Err(Failed),
    };
    writer.record(device.storage().ok_or(Failed)?, entry.address(), length)?;
    if let Some(bytes) = bits
        .to_le_bytes()
        .get(..entry.data_type.length())
        .filter(|bytes| !bytes.is_empty())
    {
        return writer.put(device.storage().ok_or(Failed)?, bytes);
    }
    // Byte by byte, as the string and the storage are both the device's.
    for nth in 0..length {
        let Ok(Value::Bytes(bytes)) = od::load(device, entry) else {
            return Err(Failed);
        };
        let byte = bytes.get(nth).copied().ok_or(Failed)?;
        writer.put(device.storage().ok_or(Failed)?, &[byte])?;
    }
    Ok(())
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
