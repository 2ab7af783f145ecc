//! Memory for what is stored. It outlives every reset, but ends with the emulator: a board has two pages of flash instead.

use lexican_runtime::storage::{Failed, Slot, Storage};

/// The two slots, each with more room than [`lexican_runtime::storage::room`] asks for.
pub(crate) type Pages = [[u8; 4096]; 2];

/// Both pages, kept where they are, and not moved with the node.
#[derive(Debug)]
pub(crate) struct Memory(pub(crate) &'static mut Pages);

impl Memory {
    fn page(&mut self, slot: Slot) -> &mut [u8] {
        let [a, b] = &mut *self.0;
        match slot {
            Slot::A => a,
            Slot::B => b,
        }
    }
}

impl Storage for Memory {
    fn read(&mut self, slot: Slot, offset: usize) -> Result<[u8; 8], Failed> {
        let bytes = self.page(slot).get(offset..).ok_or(Failed)?;
        bytes.first_chunk().copied().ok_or(Failed)
    }

    fn erase(&mut self, slot: Slot) -> Result<(), Failed> {
        self.page(slot).fill(0xFF);
        Ok(())
    }

    fn write(&mut self, slot: Slot, offset: usize, word: [u8; 8]) -> Result<(), Failed> {
        let bytes = self.page(slot).get_mut(offset..).ok_or(Failed)?;
        *bytes.first_chunk_mut().ok_or(Failed)? = word;
        Ok(())
    }
}
