//! Putting values back to what they are after power-on.

use core::ops::Range;

use super::{Access, Device, Entry, Reset};
use crate::{storage::Storage, NodeId};

/// Gives every value that an EDS writes as a formula of `$NODEID` its value for `node_id`.
pub fn resolve_node_id<D: Device>(device: &mut D, node_id: NodeId) {
    restore_all(device, None, node_id);
}

/// Gives the values that `reset` is about their values after power-on: those that a client or a PDO may write, that are
/// stored, and the formulas of `$NODEID`. What only the application writes (a serial number, a position) is the application's to reset.
pub fn restore<D: Device>(device: &mut D, reset: Reset, node_id: NodeId) {
    restore_all(device, Some(reset), node_id);
}

/// Without a `reset`, the formulas of `$NODEID` only.
#[inline(never)]
fn restore_all<D: Device>(device: &mut D, reset: Option<Reset>, node_id: NodeId) {
    for place in 0..device.table().entries.len() {
        let Some(entry) = device.table().entries.get(place).copied() else {
            return;
        };
        if reset.is_some_and(|reset| !reset.includes(entry.index)) {
            continue;
        }
        if entry.access.has(Access::NODE_ID) {
            restore_value(device, entry, node_id.get());
        } else if reset.is_some() && is_set(device, entry) {
            restore_value(device, entry, 0);
        }
    }
}

/// Whether a client or a PDO may write it, or it comes from the memory.
fn is_set<D: Device>(device: &mut D, entry: Entry) -> bool {
    let is_written = entry.access.has(Access::WRITE) || entry.access.has(Access::RPDO);
    is_written || device.storage().is_some_and(|storage| storage.group(entry).is_some())
}

/// Copies the default and adds `summand` to it, byte by byte from the lowest on. A sum that wraps does so within the type.
fn restore_value<D: Device>(device: &mut D, entry: Entry, summand: u8) {
    let Range { start, end } = bytes_of(device, entry);
    let mut carry = u16::from(summand);
    for nth in 0..end - start {
        let at = if cfg!(target_endian = "little") {
            start + nth
        } else {
            end - 1 - nth
        };
        carry += u16::from(device.defaults().get(at).copied().unwrap_or(0));
        let [byte, next] = carry.to_le_bytes();
        if let Some(place) = device.values_mut().get_mut(at) {
            *place = byte;
        }
        carry = u16::from(next);
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
