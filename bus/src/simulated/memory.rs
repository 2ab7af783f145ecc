//! Memory that outlives a node, and fails when one wants it to.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use lexican_runtime::{
    od::Entry,
    storage::{Failed, Group, Slot, Storage},
};

/// Two slots of flash or EEPROM. Clones are the same memory, so that a node can be switched off and another one started.
#[derive(Clone, Debug)]
pub struct Memory(Arc<Mutex<Cells>>);

#[derive(Debug)]
struct Cells {
    slots: [Vec<u8>; 2],
    is_flash: bool,
    /// How many bytes can be written before the power fails.
    energy: usize,
    /// The groups of some indices, beside [`Group::of`].
    groups: Vec<(u16, Option<Group>)>,
    erased: usize,
}

impl Memory {
    /// Two pages of flash of `size` bytes each, erased: a byte can be written once after each erasing.
    #[must_use]
    pub fn flash(size: usize) -> Self {
        Self::new(size, true)
    }

    /// An EEPROM with two halves of `size` bytes each, of which nobody knows what is in them.
    #[must_use]
    pub fn eeprom(size: usize) -> Self {
        Self::new(size, false)
    }

    fn new(size: usize, is_flash: bool) -> Self {
        let content = if is_flash { 0xFF } else { 0xA5 };
        Self(Arc::new(Mutex::new(Cells {
            slots: [vec![content; size], vec![content; size]],
            is_flash,
            energy: usize::MAX,
            groups: Vec::new(),
            erased: 0,
        })))
    }

    /// What is stored of the object at `index` belongs to `group`.
    #[must_use]
    pub fn with_group(self, index: u16, group: Option<Group>) -> Self {
        self.cells().groups.push((index, group));
        self
    }

    /// The power fails after so many bytes written; from then on nothing can be done until [`Memory::power_on`].
    pub fn fail_after(&self, bytes: usize) {
        self.cells().energy = bytes;
    }

    /// The power is back.
    pub fn power_on(&self) {
        self.cells().energy = usize::MAX;
    }

    /// Changes a byte of a slot, if there is one.
    pub fn damage(&self, slot: Slot, offset: usize) {
        if let Some(byte) = self.cells().slot_mut(slot).get_mut(offset) {
            *byte ^= 0x40;
        }
    }

    /// What is in a slot.
    #[must_use]
    pub fn content(&self, slot: Slot) -> Vec<u8> {
        self.cells().slot_mut(slot).clone()
    }

    /// A memory with the same content, and a life of its own.
    #[must_use]
    pub fn copy(&self) -> Self {
        let cells = self.cells();
        Self(Arc::new(Mutex::new(Cells {
            slots: cells.slots.clone(),
            groups: cells.groups.clone(),
            is_flash: cells.is_flash,
            energy: cells.energy,
            erased: cells.erased,
        })))
    }

    /// How many times a slot was erased.
    #[must_use]
    pub fn erased(&self) -> usize {
        self.cells().erased
    }
}

impl Memory {
    fn cells(&self) -> MutexGuard<'_, Cells> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Cells {
    fn slot_mut(&mut self, slot: Slot) -> &mut Vec<u8> {
        let [first, second] = &mut self.slots;
        match slot as usize {
            0 => first,
            _ => second,
        }
    }

    /// Whether there is power for one more byte.
    fn spend(&mut self) -> Result<(), Failed> {
        self.energy = self.energy.checked_sub(1).ok_or(Failed)?;
        Ok(())
    }

    fn put(&mut self, slot: Slot, offset: usize, byte: u8) -> Result<(), Failed> {
        self.spend()?;
        let is_flash = self.is_flash;
        let cell = self.slot_mut(slot).get_mut(offset).ok_or(Failed)?;
        // Flash is written once after each erasing.
        if is_flash && *cell != 0xFF {
            return Err(Failed);
        }
        *cell = byte;
        Ok(())
    }
}

impl Storage for Memory {
    fn read(&mut self, slot: Slot, offset: usize) -> Result<[u8; 8], Failed> {
        let mut cells = self.cells();
        let word = cells.slot_mut(slot).get(offset..offset.saturating_add(8));
        word.and_then(|word| word.try_into().ok()).ok_or(Failed)
    }

    fn erase(&mut self, slot: Slot) -> Result<(), Failed> {
        let mut cells = self.cells();
        cells.erased += 1;
        if cells.is_flash {
            cells.spend()?;
            cells.slot_mut(slot).fill(0xFF);
            return Ok(());
        }
        (0..8).try_for_each(|offset| cells.put(slot, offset, 0xFF))
    }

    fn write(&mut self, slot: Slot, offset: usize, word: [u8; 8]) -> Result<(), Failed> {
        let mut cells = self.cells();
        (offset..)
            .zip(word)
            .try_for_each(|(offset, byte)| cells.put(slot, offset, byte))
    }

    fn group(&self, entry: Entry) -> Option<Group> {
        let cells = self.cells();
        let own = cells.groups.iter().find(|(index, _)| *index == entry.index);
        own.map_or_else(|| Group::of(entry), |(_, group)| *group)
    }
}
