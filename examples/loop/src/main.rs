//! An encoder in a bare loop, with a master that follows a script: prints what goes over the bus.
//!
//! `cargo run -p loop` in `examples/`. On a microcontroller `Can` is the driver of the CAN controller and `Can::sleep` a
//! WFI with a timer set; nothing else differs.

mod can;
mod encoder;

use lexican_runtime::{Emergency, Instant, Node, NodeId};

use can::Can;
use encoder::Encoder;

include!(concat!(env!("OUT_DIR"), "/wdga.rs"));

/// The dictionary, the application and the services of CANopen.
type Slave = Node<wdga::Device<Encoder>>;

/// The shaft is looked at so often, in ms.
const PERIOD_MS: u32 = 10;
/// 4200h: device temperature (CiA 301, table 26), which is bit 3 of the error register.
const TOO_HOT: Emergency = Emergency::new(0x4200, 1 << 3);

fn main() {
    let mut can = Can::new();
    let node_id = NodeId::new(0x7F).expect("1 to 127");
    let mut node = Node::new(wdga::Device::new(Encoder::new()), node_id);
    let mut measurement = Instant::from_millis(0);
    let mut now = measurement;
    loop {
        while let Some(frame) = can.receive(now) {
            node.receive(now, &frame);
            // The answer goes before the next request comes: the node holds but one.
            send(&mut node, now, &mut can);
        }
        if now >= measurement {
            measure(&mut node);
            measurement = now.plus_millis(PERIOD_MS);
        }
        send(&mut node, now, &mut can);

        // Nothing to do before the next measurement, the node's next timer, or the next frame.
        let due = node.poll_at().map_or(measurement, |due| due.min(measurement));
        match can.sleep(now, due) {
            Some(awake) => now = awake,
            None => return,
        }
    }
}

/// What the application does on its own: reads its sensors, writes fields, and says that something happened.
fn measure(node: &mut Slave) {
    let device = node.device_mut();
    device.handlers.turn();
    let position = device.handlers.position();
    let has_moved = position != device.od.position_value;
    device.od.position_value = position;
    device.od.temperature_current = device.handlers.temperature();
    let is_hot = device.od.temperature_current > device.od.temperature_upper_limit;

    // Both may be said again and again: an emergency is sent when it is new.
    if is_hot {
        node.raise_emergency(TOO_HOT);
    } else {
        node.clear_emergency(TOO_HOT.code);
    }
    // TPDO 1 has the transmission type 254: it is sent when the application says so.
    if has_moved {
        node.trigger_tpdo(1);
    }
}

fn send(node: &mut Slave, now: Instant, can: &mut Can) {
    while let Some(frame) = node.poll(now) {
        can.send(now, &frame);
    }
}
