//! Reading what is stored.

use super::{
    change::group_of,
    image::{Image, Reader, Settings, SETTINGS},
};
use crate::{
    lss::BitRate,
    od::{self, Access, Device, Reset},
    Address, Event, NodeId,
};

/// What LSS has stored.
pub(crate) fn settings<D: Device>(device: &mut D, image: Image) -> Option<Settings> {
    let storage = device.storage()?;
    let mut reader = Reader::of(image);
    let record = reader.record(storage)?;
    if record.address != SETTINGS {
        return None;
    }
    let mut bytes = [0; 2];
    reader.fill(storage, &mut bytes);
    let [node_id, bit_rate] = bytes;
    Some(Settings {
        node_id: NodeId::new(node_id).unwrap_or(NodeId::NONE),
        bit_rate: BitRate::from_index(bit_rate),
    })
}

/// Gives the values that `reset` is about what is stored of them.
pub(crate) fn load<D: Device>(device: &mut D, image: Image, reset: Reset) {
    let mut reader = Reader::of(image);
    let mut buffer = device.buffer();
    while let Some(record) = device.storage().and_then(|storage| reader.record(storage)) {
        let Some(storage) = device.storage() else { return };
        // What is longer than the longest value is none.
        let value = buffer.as_mut().get_mut(..record.length);
        match value {
            Some(value) => reader.fill(storage, value),
            None => reader.skip(storage, record.length),
        }
        let is_meant = record.address != SETTINGS && is_about(device, reset, record.address);
        let value = buffer.as_ref().get(..record.length);
        if is_meant && value.and_then(|value| put(device, record.address, value)).is_none() {
            device.event(Event::Dropped(record.address));
        }
    }
}

/// Whether `reset` resets the value: those that follow the node-ID too, as it may have changed.
fn is_about<D: Device>(device: &D, reset: Reset, address: Address) -> bool {
    let entry = device.table().find(address);
    reset.includes(address.index) || entry.is_some_and(|entry| entry.access.has(Access::NODE_ID))
}

fn put<D: Device>(device: &mut D, address: Address, value: &[u8]) -> Option<()> {
    group_of(device, address)?;
    od::set_within_limits(device, address, value).ok()
}
