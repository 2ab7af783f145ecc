//! Putting values back to what they are after power-on.

use core::ops::Range;

use super::{read, write, Access, Device, Entry, Reset};
use crate::NodeId;

/// Gives every value that an EDS writes as a formula of `$NODEID` its value for `node_id`.
pub fn resolve_node_id<D: Device>(device: &mut D, node_id: NodeId) {
    for place in 0..device.table().entries.len() {
        let Some(entry) = entry(device, place) else { return };
        if entry.access.has(Access::NODE_ID) {
            resolve(device, entry, node_id);
        }
    }
}

/// Gives the values that `reset` is about their values after power-on: those that a client or a PDO may write, and the
/// formulas of `$NODEID`. What only the application writes (a serial number, a position) is the application's to reset.
pub fn restore<D: Device>(device: &mut D, reset: Reset, node_id: NodeId) {
    for place in 0..device.table().entries.len() {
        let Some(entry) = entry(device, place) else { return };
        if !reset.includes(entry.index) {
            continue;
        }
        if entry.access.has(Access::NODE_ID) {
            resolve(device, entry, node_id);
        } else if entry.access.has(Access::WRITE) || entry.access.has(Access::RPDO) {
            restore_bytes(device, entry);
        }
    }
}

fn entry<D: Device>(device: &D, place: usize) -> Option<Entry> {
    device.table().entries.get(place).copied()
}

/// The default plus the node-ID. A sum that wraps does so within the type: only its low bytes are stored.
fn resolve<D: Device>(device: &mut D, entry: Entry, node_id: NodeId) {
    let Some((slot, _)) = device.table().locate(entry) else {
        return;
    };
    let base = device.defaults().get(slot..);
    let Some(base) = base.and_then(|bytes| read::bits::<D>(bytes, entry.data_type.width(), false)) else {
        return;
    };
    let _ = write::put(device, entry, base.wrapping_add(u64::from(node_id.get())));
}

/// Copies the default byte by byte, since both slices are the device's.
fn restore_bytes<D: Device>(device: &mut D, entry: Entry) {
    for at in bytes_of(device, entry) {
        if let Some(default) = device.defaults().get(at).copied() {
            if let Some(byte) = device.values_mut().get_mut(at) {
                *byte = default;
            }
        }
    }
}

/// Where the value of `entry` stands; a string with its length.
fn bytes_of<D: Device>(device: &D, entry: Entry) -> Range<usize> {
    let Some((slot, detail)) = device
        .table()
        .locate(entry)
        .filter(|_| !entry.access.has(Access::CONSTANT))
    else {
        return 0..0;
    };
    let length = match entry.data_type.width() {
        0 => detail + 2,
        width => width,
    };
    slot..slot + length
}
