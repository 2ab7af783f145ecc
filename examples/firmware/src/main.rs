//! An encoder on an LM3S6965, whose CAN bus is a serial line: the board has no CAN controller that an emulator knows, so
//! frames go over UART0 in slcan, and the firmware is its own adapter.
//!
//! | module | does |
//! |---|---|
//! | `encoder` | answers for the objects that are more than stored values |
//! | `adapter` | obeys the host's slcan commands |
//! | `memory` | keeps what is stored |
//! | `uart`, `clock` | the two peripherals, and their interrupts |

#![no_std]
#![no_main]

mod adapter;
mod clock;
mod encoder;
mod memory;
mod uart;

use core::panic::PanicInfo;

use cortex_m_rt::entry;
use lexican_runtime::{Node, NodeId};

use adapter::Adapter;
use clock::Clock;
use encoder::Encoder;
use memory::{Memory, Pages};

include!(concat!(env!("OUT_DIR"), "/wdga.rs"));

/// The whole device.
type Slave = Node<wdga::Device<Encoder, Memory>>;

/// What the device is delivered with.
const NODE_ID: NodeId = match NodeId::new(0x7F) {
    Some(node_id) => node_id,
    None => unreachable!(),
};

#[entry]
fn main() -> ! {
    static mut PAGES: Pages = [[0; 4096]; 2];
    let (Some(mut clock), Some(node)) = (start(), power_on(PAGES)) else {
        // Each is taken for the first and only time.
        halt()
    };
    let mut adapter = Adapter::new();
    loop {
        let now = clock.now();
        while let Some(byte) = uart::receive() {
            if let Some(frame) = adapter.receive(byte) {
                node.receive(now, &frame);
                // An answer goes before the next request comes: the node holds but one.
                send(node, &adapter, &mut clock);
            }
        }
        send(node, &adapter, &mut clock);
        clock.sleep_until(node.poll_at().filter(|_| adapter.is_open()), uart::is_idle);
    }
}

/// Switches the interrupts on.
fn start() -> Option<Clock> {
    let peripherals = cortex_m::Peripherals::take()?;
    uart::start();
    Some(Clock::start(peripherals.SYST))
}

/// The node, which is not on the stack, so that the linker knows its place and both can be weighed.
///
/// Not inlined: what making it takes of the stack is free again afterwards.
#[inline(never)]
fn power_on(pages: &'static mut Pages) -> Option<&'static mut Slave> {
    let device = wdga::Device::with_storage(Encoder, Memory(pages));
    cortex_m::singleton!(: Slave = Node::new(device, NODE_ID))
}

/// Sends all that the node has to say. A node whose adapter is closed is not on the bus, and waits.
fn send(node: &mut Slave, adapter: &Adapter, clock: &mut Clock) {
    while adapter.is_open() {
        let now = clock.now();
        let Some(frame) = node.poll(now) else { return };
        adapter.send(now, &frame);
    }
}

/// Nothing in this image panics, which its build proves by its symbols; the language wants a handler all the same.
#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    halt()
}

fn halt() -> ! {
    loop {
        cortex_m::asm::wfi();
    }
}
