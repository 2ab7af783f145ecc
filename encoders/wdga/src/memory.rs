//! Which objects are stored together, and which outlive a restore.

use lexican_runtime::{
    od::Entry,
    storage::{Failed, Group, Slot, Storage},
};

/// 2120h: customer data, stored as they are written.
pub(crate) const CUSTOMER: Group = Group(0x80);
/// 2502h to 2504h: histories, stored as they grow.
pub(crate) const HISTORY: Group = Group(0x81);

/// A storage that knows the groups of a WDGA (chapters 7.12 and 8.12): node-ID and baud rate are stored as LSS does, customer
/// data and histories at once, the preset's offset with the application's parameters.
#[derive(Clone, Debug)]
pub struct Memory<M>(pub M);

impl<M: Storage> Storage for Memory<M> {
    const CAPABILITIES: u32 = M::CAPABILITIES;

    fn read(&mut self, slot: Slot, offset: usize) -> Result<[u8; 8], Failed> {
        self.0.read(slot, offset)
    }

    fn erase(&mut self, slot: Slot) -> Result<(), Failed> {
        self.0.erase(slot)
    }

    fn write(&mut self, slot: Slot, offset: usize, word: [u8; 8]) -> Result<(), Failed> {
        self.0.write(slot, offset, word)
    }

    fn finish(&mut self, slot: Slot) -> Result<(), Failed> {
        self.0.finish(slot)
    }

    fn group(&self, entry: Entry) -> Option<Group> {
        match (entry.index, entry.sub) {
            (0x2100 | 0x2101, _) => None,
            (0x2120, 1..) => Some(CUSTOMER),
            (0x2502 | 0x2503, 1..) | (0x2504, _) => Some(HISTORY),
            (0x6509, _) => Some(Group::APPLICATION),
            _ => Group::of(entry),
        }
    }
}
