//! An encoder with embassy: one task has the node, others bring it frames and measurements.
//!
//! `cargo run -p embassy` in `examples/`. It runs on this computer; on a microcontroller the executor's and the clock's
//! features are another platform's, `bus` is the driver of the CAN controller, and nothing else differs: no task needs
//! more than `core`.

mod bus;
mod encoder;

use embassy_executor::Spawner;
use embassy_futures::select::{Either3, select3};
use embassy_sync::{blocking_mutex::raw::CriticalSectionRawMutex, channel::Channel, signal::Signal};
use embassy_time::{Instant as Clock, Timer};
use lexican_runtime::{Address, Emergency, Frame, Instant, Node, NodeId};

use encoder::Encoder;

include!(concat!(env!("OUT_DIR"), "/wdga.rs"));

/// The dictionary, the application and the services of CANopen.
type Slave = Node<wdga::Device<Encoder>>;

/// What came in from the bus, and what is to go out.
static RECEIVED: Frames = Channel::new();
static TO_SEND: Frames = Channel::new();
type Frames = Channel<CriticalSectionRawMutex, Frame, 8>;

/// The newest measurement; one that nobody has looked at is no longer worth it.
static MEASURED: Signal<CriticalSectionRawMutex, Measurement> = Signal::new();

/// What the sensor says.
#[derive(Clone, Copy, Debug)]
struct Measurement {
    position: u32,
    /// In degrees Celsius.
    temperature: i16,
}

const POSITION_VALUE: Address = Address::new(0x6004, 0);
/// 4200h: device temperature (CiA 301, table 26), which is bit 3 of the error register.
const TOO_HOT: Emergency = Emergency::new(0x4200, 1 << 3);

#[embassy_executor::main]
async fn main(spawner: Spawner) {
    const ONCE: &str = "each task is spawned once";
    spawner.spawn(measure().expect(ONCE));
    spawner.spawn(bus::receive().expect(ONCE));
    spawner.spawn(bus::send().expect(ONCE));
    slave().await;
}

/// The node: sleeps until a frame comes, a measurement, or its own next timer.
async fn slave() {
    let node_id = NodeId::new(0x7F).expect("1 to 127");
    let mut node = Node::new(wdga::Device::new(Encoder), node_id);
    loop {
        let woken = select3(RECEIVED.receive(), MEASURED.wait(), due(&node)).await;
        let now = Instant::from_micros(Clock::now().as_micros());
        match woken {
            Either3::First(frame) => node.receive(now, &frame),
            Either3::Second(measurement) => take(&mut node, measurement),
            Either3::Third(()) => {}
        }
        while let Some(frame) = node.poll(now) {
            TO_SEND.send(frame).await;
        }
    }
}

/// Until the node has something to do by itself.
async fn due(node: &Slave) {
    match node.poll_at() {
        Some(due) => Timer::at(Clock::from_micros(due.as_micros())).await,
        None => core::future::pending().await,
    }
}

/// Writes fields, and says that something happened.
fn take(node: &mut Slave, measurement: Measurement) {
    let od = &mut node.device_mut().od;
    let has_moved = measurement.position != od.position_value;
    od.position_value = measurement.position;
    od.temperature_current = measurement.temperature;
    let is_hot = od.temperature_current > od.temperature_upper_limit;

    // Both may be said again and again: an emergency is sent when it is new.
    if is_hot {
        node.raise_emergency(TOO_HOT);
    } else {
        node.clear_emergency(TOO_HOT.code);
    }
    // Every TPDO that carries the position and may go by an event is sent; `trigger_tpdo(1)` names one instead.
    if has_moved {
        node.object_changed(POSITION_VALUE);
    }
}

/// A shaft that turns, and is hot for a while.
#[embassy_executor::task]
async fn measure() {
    for position in (0..).step_by(100) {
        let temperature = if (300..600).contains(&position) { 120 } else { 20 };
        MEASURED.signal(Measurement { position, temperature });
        Timer::after_millis(20).await;
    }
}
