//! UART0, a PL011: what comes in is kept by its interrupt, what goes out waits for room.

use core::sync::atomic::{AtomicBool, AtomicU8, Ordering};

use cortex_m::peripheral::NVIC;
use lm3s6965::{Interrupt, interrupt};

/// Its registers.
const UART0: usize = 0x4000_C000;
/// Data; above it the errors of the byte.
const DATA: usize = 0x000;
/// Flags.
const FLAGS: usize = 0x018;
/// Line control.
const LINE_CONTROL: usize = 0x02C;
/// Control.
const CONTROL: usize = 0x030;
/// Which interrupts are let through.
const INTERRUPT_MASK: usize = 0x038;

/// [`DATA`]: a byte was lost before this one.
const OVERRUN: u32 = 1 << 11;
/// [`FLAGS`]: nothing has come in.
const RECEIVER_EMPTY: u32 = 1 << 4;
/// [`FLAGS`]: there is no room for another byte.
const TRANSMITTER_FULL: u32 = 1 << 5;
/// [`LINE_CONTROL`]: eight bits, with the FIFOs on.
const EIGHT_BITS_FIFO: u32 = 0b11 << 5 | 1 << 4;
/// [`CONTROL`]: the UART, its transmitter and its receiver on.
const ENABLE: u32 = 1 << 9 | 1 << 8 | 1 << 0;
/// [`INTERRUPT_MASK`]: the receive FIFO is half full, or something has been in it for 32 bits' time.
const RECEIVED: u32 = 1 << 6 | 1 << 4;

/// What came in and was not taken yet: the interrupt writes at `HEAD`, the main loop reads at `TAIL`. The numbers wrap
/// with the array.
static BYTES: [AtomicU8; 256] = [const { AtomicU8::new(0) }; 256];
static HEAD: AtomicU8 = AtomicU8::new(0);
static TAIL: AtomicU8 = AtomicU8::new(0);
/// A byte was lost.
static IS_OVERRUN: AtomicBool = AtomicBool::new(false);

/// Switches it and its interrupt on. The baud rate is left to the emulator, whose line is as fast as it can.
pub(crate) fn start() {
    write(LINE_CONTROL, EIGHT_BITS_FIFO);
    write(CONTROL, ENABLE);
    write(INTERRUPT_MASK, RECEIVED);
    // SAFETY: no critical section relies on this interrupt being masked.
    unsafe { NVIC::unmask(Interrupt::UART0) };
}

/// The next byte that came in.
pub(crate) fn receive() -> Option<u8> {
    let tail = TAIL.load(Ordering::Relaxed);
    if tail == HEAD.load(Ordering::Acquire) {
        return None;
    }
    let byte = BYTES[usize::from(tail)].load(Ordering::Relaxed);
    TAIL.store(tail.wrapping_add(1), Ordering::Release);
    // There is room again, if there was none.
    write(INTERRUPT_MASK, RECEIVED);
    Some(byte)
}

/// Whether everything that came in was taken.
pub(crate) fn is_idle() -> bool {
    TAIL.load(Ordering::Relaxed) == HEAD.load(Ordering::Acquire)
}

/// Sends `bytes`, and waits until the last has room.
pub(crate) fn send(bytes: &[u8]) {
    for &byte in bytes {
        while read(FLAGS) & TRANSMITTER_FULL != 0 {}
        write(DATA, u32::from(byte));
    }
}

/// The status of slcan since it was last asked for: bit 3 when a byte was lost.
pub(crate) fn status() -> u8 {
    let overrun = IS_OVERRUN.load(Ordering::Relaxed);
    IS_OVERRUN.store(false, Ordering::Relaxed);
    u8::from(overrun) << 3
}

/// Takes what is in the FIFO. When the main loop is 255 bytes behind, the rest stays there, and the interrupt stays off
/// until there is room.
#[interrupt]
fn UART0() {
    while read(FLAGS) & RECEIVER_EMPTY == 0 {
        let head = HEAD.load(Ordering::Relaxed);
        let next = head.wrapping_add(1);
        if next == TAIL.load(Ordering::Acquire) {
            write(INTERRUPT_MASK, 0);
            return;
        }
        let data = read(DATA);
        if data & OVERRUN != 0 {
            IS_OVERRUN.store(true, Ordering::Relaxed);
        }
        BYTES[usize::from(head)].store(data as u8, Ordering::Relaxed);
        HEAD.store(next, Ordering::Release);
    }
}

fn read(register: usize) -> u32 {
    // SAFETY: a register of the UART, which nothing else in this image touches; reading it has no effect on memory.
    unsafe { ((UART0 + register) as *const u32).read_volatile() }
}

fn write(register: usize, value: u32) {
    // SAFETY: as above; the UART does not write to memory.
    unsafe { ((UART0 + register) as *mut u32).write_volatile(value) }
}
