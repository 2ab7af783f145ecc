//! The EEPROM: any storage, with what this encoder keeps in it.

use lexican_runtime::{
    od::Entry,
    storage::{Failed, Group, Slot, Storage},
};

/// The error history: stored by the encoder itself, and kept by every restore (manual, 5.7.2.4).
pub(crate) const HISTORY: Group = Group(0x80);

/// A storage that knows which values of this encoder are stored.
#[derive(Clone, Debug)]
pub struct Memory<M>(pub(crate) M);

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

    /// As the manual's rows "EEPROM" say.
    fn group(&self, entry: Entry) -> Option<Group> {
        match entry.index {
            0x1003 => Some(HISTORY),
            // LSS stores node-ID and bit rate, whichever way they were set; 6002h follows 6001h.
            0x5F0A | 0x6002 => None,
            // What a calibration has found.
            0x6509 => Some(Group::APPLICATION),
            _ => Group::of(entry),
        }
    }
}
