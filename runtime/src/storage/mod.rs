//! Storing parameters: 1010h and 1011h (CiA 301, 7.5.2.13 and 7.5.2.14), 1020h, and what LSS configures.
//!
//! The application lends the node two slots of memory that outlives power-off ([`Storage`]): two pages of flash, or two
//! halves of an EEPROM. Each holds one whole image of what is stored; a new one goes into the slot whose image is the older
//! one. So when the power fails while one is written, the other is there, whole.
//!
//! ```text
//! 4C 78 01 00   sequence number, u32     a new image has the next one; the newest whole image counts
//! index u16   sub u8   length u16   value as on the bus        once for each value
//! 00 00 00 00 00                         the end
//! check value, u32                       CRC-32 of all before it; up to 7 bytes FFh fill the last word
//! ```
//!
//! All numbers are little-endian. The value of "index" 0001h is the node-ID and the bit rate of LSS, each FFh for none.
//!
//! What is stored: each value of a saved group that a client may read and write, whether it differs from its default or
//! not, so that another default in a later version of the dictionary does not change a saved configuration. So the COB-IDs
//! that follow the node-ID (`$NODEID` in an EDS) are frozen by a save, and freed by a restore. Not stored are process data
//! (what may be in an RPDO and not in a TPDO), the error history, DOMAINs, and commands: 1010h, 1011h, 1023h to 1026h, 1F50h
//! to 1F5Fh. [`Storage::group`] may decide otherwise.
//!
//! * A save keeps what is stored of other groups.
//! * A restore forgets what is stored of the group, at once; the defaults are there after the next reset of the node, for
//!   communication parameters also of the communication. What LSS has stored stays.
//! * What is stored is loaded at power-on and after resets, without calling the application's handlers. A value that does
//!   not fit any more, because its object is not there or not stored, or its length or limits are others, is dropped, and
//!   told by [`Event::Dropped`](crate::Event::Dropped).
//! * 1020h, verify configuration, becomes 0 when a client writes a value that is stored, and by a restore; a save keeps it.

mod change;
mod group;
mod image;
mod load;
mod parameters;

pub(crate) use change::{change, Change};
pub use group::Group;
pub(crate) use image::{newest, Image, Settings};
pub(crate) use load::{load, settings};
pub(crate) use parameters::{after_write, before_write, show_capabilities};

use crate::od::{Device, Entry, ServiceSet};

/// Memory that outlives power-off, in two slots that are erased and written independently of one another.
///
/// A slot is to have room for [`room`] bytes. Words are of eight bytes, offsets are in bytes, multiples of eight. After
/// [`Storage::erase`] a slot is written from its beginning on, word by word without a gap, each word once: so flash may be
/// programmed as it comes, and where it is programmed in larger units words may be collected until [`Storage::finish`].
///
/// The calls block: a client waits for the answer to its save that long, and the node does nothing else.
///
/// Flash that is programmed 32 bytes at a time, in two pages:
///
/// ```
/// use lexican_runtime::storage::{Failed, Slot, Storage};
/// # struct Flash([u8; 4096]);
/// # impl Flash {
/// #     fn read(&self, at: usize) -> [u8; 8] { self.0[at..at + 8].try_into().unwrap() }
/// #     fn erase_page(&mut self, page: usize) { self.0[page * 2048..][..2048].fill(0xFF) }
/// #     fn program(&mut self, at: usize, unit: &[u8; 32]) -> bool { self.0[at..at + 32].copy_from_slice(unit); true }
/// # }
///
/// struct Pages {
///     flash: Flash,
///     /// What is programmed next, and how much of it there is.
///     unit: [u8; 32],
///     used: usize,
///     next: usize,
/// }
///
/// const PAGE: usize = 2048;
///
/// impl Storage for Pages {
///     fn read(&mut self, slot: Slot, offset: usize) -> Result<[u8; 8], Failed> {
///         if offset >= PAGE {
///             return Err(Failed);
///         }
///         Ok(self.flash.read(slot as usize * PAGE + offset))
///     }
///
///     fn erase(&mut self, slot: Slot) -> Result<(), Failed> {
///         self.flash.erase_page(slot as usize);
///         (self.unit, self.used, self.next) = ([0xFF; 32], 0, slot as usize * PAGE);
///         Ok(())
///     }
///
///     fn write(&mut self, slot: Slot, offset: usize, word: [u8; 8]) -> Result<(), Failed> {
///         if offset >= PAGE {
///             return Err(Failed);
///         }
///         self.unit[self.used..][..8].copy_from_slice(&word);
///         self.used += 8;
///         if self.used == 32 {
///             self.finish(slot)?;
///         }
///         Ok(())
///     }
///
///     fn finish(&mut self, _: Slot) -> Result<(), Failed> {
///         if self.used != 0 && !self.flash.program(self.next, &self.unit) {
///             return Err(Failed);
///         }
///         (self.unit, self.used, self.next) = ([0xFF; 32], 0, self.next + 32);
///         Ok(())
///     }
/// }
/// # let mut pages = Pages { flash: Flash([0; 4096]), unit: [0; 32], used: 0, next: 0 };
/// # pages.erase(Slot::B).unwrap();
/// # for word in 0..5 { pages.write(Slot::B, 8 * word, [word as u8; 8]).unwrap(); }
/// # pages.finish(Slot::B).unwrap();
/// # for word in 0..5 { assert_eq!(pages.read(Slot::B, 8 * word), Ok([word as u8; 8])); }
/// # assert_eq!(pages.read(Slot::B, 40), Ok([0xFF; 8]));
/// ```
///
/// The device takes it when it is made: `wdga::Device::with_storage(handlers, pages)`.
pub trait Storage {
    /// What 1010h says that this storage does ([`SAVES_ON_COMMAND`], [`SAVES_AUTONOMOUSLY`]); 0 for nothing at all.
    const CAPABILITIES: u32 = SAVES_ON_COMMAND;

    /// The word at `offset` of a slot.
    ///
    /// # Errors
    /// [`Failed`] when it cannot be read, or `offset` is beyond the slot.
    fn read(&mut self, slot: Slot, offset: usize) -> Result<[u8; 8], Failed>;

    /// Makes a slot ready to be written. Memory that needs no erasing is to have FFh written over its first word: then what
    /// stood there does not count any more.
    ///
    /// # Errors
    /// [`Failed`] when it cannot be erased.
    fn erase(&mut self, slot: Slot) -> Result<(), Failed>;

    /// Writes the word at `offset` of a slot.
    ///
    /// # Errors
    /// [`Failed`] when it cannot be written, or `offset` is beyond the slot.
    fn write(&mut self, slot: Slot, offset: usize, word: [u8; 8]) -> Result<(), Failed>;

    /// Writes what it has held back of a slot. Does nothing unless overridden.
    ///
    /// # Errors
    /// [`Failed`] when it cannot be written.
    fn finish(&mut self, slot: Slot) -> Result<(), Failed> {
        let _ = slot;
        Ok(())
    }

    /// The group with which the value of `entry` is stored, `None` for never: [`Group::of`] unless overridden.
    ///
    /// A manufacturer's own groups have the numbers 5 to 127, and from 128 on where no restore is to forget them. So a persistent
    /// error history is 1003h in a group of its
    /// own, which the application saves ([`Node::save`](crate::Node::save)) after it has raised an emergency.
    fn group(&self, entry: Entry) -> Option<Group> {
        Group::of(entry)
    }
}

/// Bit 0 of 1010h: parameters are saved when a client says so.
pub const SAVES_ON_COMMAND: u32 = 0x01;
/// Bit 1 of 1010h: parameters are saved without being told to; by the application, with [`Node::save`](crate::Node::save).
pub const SAVES_AUTONOMOUSLY: u32 = 0x02;

/// One of the two places for an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Slot {
    /// The first.
    A,
    /// The second.
    B,
}

impl Slot {
    /// The other one.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::A => Self::B,
            Self::B => Self::A,
        }
    }
}

/// The memory does not do what it is to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Failed;

/// No memory: 1010h and 1011h read 0, and refuse.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoStorage;

impl Storage for NoStorage {
    const CAPABILITIES: u32 = 0;

    fn read(&mut self, _: Slot, _: usize) -> Result<[u8; 8], Failed> {
        Err(Failed)
    }

    fn erase(&mut self, _: Slot) -> Result<(), Failed> {
        Err(Failed)
    }

    fn write(&mut self, _: Slot, _: usize, _: [u8; 8]) -> Result<(), Failed> {
        Err(Failed)
    }
}

/// How many bytes each slot needs for all that `device` may store.
#[must_use]
pub fn room<D: Device>(device: &mut D) -> usize {
    change::room(device)
}

/// What the storage of `device` does, of a generated device a constant: 0 for none.
pub(crate) fn capabilities<D: Device>(device: &mut D) -> u32 {
    let is_there = D::SERVICES.has(ServiceSet::STORAGE.with(ServiceSet::LSS)) && device.storage().is_some();
    if is_there {
        D::Storage::CAPABILITIES
    } else {
        0
    }
}
