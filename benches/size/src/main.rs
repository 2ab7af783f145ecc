//! An encoder's firmware without the encoder: the bus, the clock and the memory for what is stored are addresses that are
//! read and written.

#![no_std]
#![no_main]

use core::{mem::MaybeUninit, ptr};

use cortex_m_rt::entry;
// The vector table of a chip.
use lexican_runtime::{
    storage::{Failed, Slot, Storage},
    CanId, Frame, Instant, Node, NodeId,
};
use lm3s6965 as _;

include!(concat!(env!("OUT_DIR"), "/dictionary.rs"));

/// Identifier, length, data, data; then the clock.
const BUS: *mut u32 = 0x4000_0000 as *mut u32;

type Device = dictionary::Device<(), Memory>;

/// Two slots, one behind the other.
const MEMORY: *mut [u8; 8] = 0x4100_0000 as *mut [u8; 8];

/// Bytes of a slot.
const SLOT: usize = 2048;

/// Outside the stack, so that it is weighed.
static mut NODE: MaybeUninit<Node<Device>> = MaybeUninit::uninit();

#[entry]
fn main() -> ! {
    // SAFETY: there is but one thread, and `main` runs once.
    let node = unsafe {
        (*ptr::addr_of_mut!(NODE)).write(Node::new(Device::with_storage((), Memory), NodeId::new(0x10).unwrap()))
    };
    loop {
        let now = Instant::from_micros(u64::from(read(4)));
        if let Some(frame) = receive() {
            node.receive(now, &frame);
        }
        while let Some(frame) = node.poll(now) {
            send(&frame);
        }
    }
}

/// A memory that can be written at any time, as an EEPROM or FRAM.
struct Memory;

impl Memory {
    fn word(slot: Slot, offset: usize) -> Result<*mut [u8; 8], Failed> {
        if offset >= SLOT {
            return Err(Failed);
        }
        Ok(MEMORY.wrapping_add((slot as usize * SLOT + offset) / 8))
    }
}

impl Storage for Memory {
    fn read(&mut self, slot: Slot, offset: usize) -> Result<[u8; 8], Failed> {
        // SAFETY: on a real device, memory of this size.
        Self::word(slot, offset).map(|word| unsafe { word.read_volatile() })
    }

    fn erase(&mut self, slot: Slot) -> Result<(), Failed> {
        self.write(slot, 0, [0xFF; 8])
    }

    fn write(&mut self, slot: Slot, offset: usize, word: [u8; 8]) -> Result<(), Failed> {
        // SAFETY: as above.
        Self::word(slot, offset).map(|place| unsafe { place.write_volatile(word) })
    }
}

fn receive() -> Option<Frame> {
    let data = u64::from(read(3)) << 32 | u64::from(read(2));
    let data = data.to_le_bytes();
    Frame::new(CanId::standard(read(0))?, data.get(..read(1) as usize)?)
}

fn send(frame: &Frame) {
    let mut data = [0; 8];
    data.iter_mut().zip(frame.data()).for_each(|(to, from)| *to = *from);
    let data = u64::from_le_bytes(data);
    write(0, frame.id().number());
    write(1, frame.length() as u32);
    write(2, data as u32);
    write(3, (data >> 32) as u32);
}

fn read(word: usize) -> u32 {
    // SAFETY: on a real device, a register of its CAN controller.
    unsafe { BUS.add(word).read_volatile() }
}

fn write(word: usize, value: u32) {
    // SAFETY: as above.
    unsafe { BUS.add(word).write_volatile(value) }
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
