//! Multiplexed PDOs (CiA 301, 7.2.2.4 and objects 1FA0h to 1FFFh): a PDO that says itself which object it carries.
//!
//! ```text
//! byte     0                1  2     3      4  5  6  7
//! DAM      80h + receiver   object   sub    value         mapping FFh; the receiver's object; receiver 0 is all nodes
//! SAM      sender           object   sub    value         mapping FEh; the sender's object, which the receiver looks up
//! ```
//!
//! A sender's scanner lists (1FA0h to 1FCFh) say which of its objects are sent when they change; a receiver's dispatching
//! lists (1FD0h to 1FFFh) say which of its own objects takes the value.
//!
//! What CiA 301 leaves open: a value that no object takes, or that its object refuses, is dropped without a word.

use crate::{
    od::{self, Access, Device},
    Address, NodeId,
};

/// A mapping's sub-index 0 for PDOs with the address at the sender.
pub(super) const SOURCE: u8 = 0xFE;
/// A mapping's sub-index 0 for PDOs with the address at the receiver.
pub(super) const DESTINATION: u8 = 0xFF;

/// Set in the first byte for an address at the receiver.
const TO_RECEIVER: u8 = 0x80;

/// Whether a mapping with this sub-index 0 names no objects, but says that each PDO does so itself.
pub(super) const fn is_multiplexed(count: u32) -> bool {
    matches!(count, 0xFE | 0xFF)
}

/// The eight bytes with the value of an object of this node, for all nodes.
pub(super) const fn from_source(sender: NodeId, address: Address, value: u32) -> u64 {
    word(sender.get(), address, value)
}

/// The eight bytes with a value for the object at `address` of `receiver`; of all nodes for `None`.
pub(super) const fn to_destination(receiver: Option<NodeId>, address: Address, value: u32) -> u64 {
    let receiver = match receiver {
        Some(node_id) => node_id.get(),
        None => 0,
    };
    word(TO_RECEIVER | receiver, address, value)
}

const fn word(node: u8, address: Address, value: u32) -> u64 {
    let [i0, i1] = address.index.to_le_bytes();
    let [v0, v1, v2, v3] = value.to_le_bytes();
    u64::from_le_bytes([node, i0, i1, address.sub, v0, v1, v2, v3])
}

/// Gives the object that `word` is for its value, if there is one here.
pub(super) fn receive<D: Device>(device: &mut D, node_id: NodeId, count: u8, word: u64) {
    let [node, i0, i1, sub, v0, v1, v2, v3] = word.to_le_bytes();
    let address = Address::new(u16::from_le_bytes([i0, i1]), sub);
    let (is_to_receiver, node) = (node & TO_RECEIVER != 0, node & !TO_RECEIVER);
    let own = match count {
        DESTINATION if is_to_receiver && (node == 0 || node == node_id.get()) => Some(address),
        SOURCE if !is_to_receiver => dispatched(device, node, address),
        _ => None,
    };
    let entry = own.and_then(|address| device.table().find(address));
    if let Some(entry) = entry.filter(|entry| entry.access.has(Access::RPDO)) {
        let _ = od::store_number(device, &mut (), entry, u32::from_le_bytes([v0, v1, v2, v3]).into());
    }
}

/// The object here that takes the value of the object at `address` of the node `sender`.
fn dispatched<D: Device>(device: &D, sender: u8, address: Address) -> Option<Address> {
    entries(device, 0x1FD0..0x2000).find_map(|entry| {
        let [node, s, i0, i1, own_sub, j0, j1, block] = entry.to_le_bytes();
        let from = Address::new(u16::from_le_bytes([i0, i1]), s);
        let nth = position(from, block, address).filter(|_| node == sender)?;
        let own_sub = own_sub.checked_add(nth)?;
        Some(Address::new(u16::from_le_bytes([j0, j1]), own_sub))
    })
}

/// Whether a change of the object at `address` is to be sent.
pub(super) fn is_scanned<D: Device>(device: &D, address: Address) -> bool {
    entries(device, 0x1FA0..0x1FD0).any(|entry| {
        let [sub, i0, i1, block, ..] = entry.to_le_bytes();
        position(Address::new(u16::from_le_bytes([i0, i1]), sub), block, address).is_some()
    })
}

/// The entries of lists that are not empty.
fn entries<D: Device>(device: &D, lists: core::ops::Range<u16>) -> impl Iterator<Item = u64> + '_ {
    let addresses =
        lists.flat_map(|index| (1..=device.table().elements(index)).map(move |sub| Address::new(index, sub)));
    addresses
        .filter_map(|address| od::number(device, address))
        .filter(|entry| *entry != 0)
}

/// Which one `address` is in the block of sub-indices that begins at `first`; a block of 0 has one.
fn position(first: Address, block: u8, address: Address) -> Option<u8> {
    let nth = address.sub.checked_sub(first.sub)?;
    (address.index == first.index && nth < block.max(1)).then_some(nth)
}
