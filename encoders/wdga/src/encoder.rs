//! Ties sensor, node and time together.

use lexican_runtime::{
    BusState, Frame, Instant, Node, NodeId, lss::BitRate, profile::encoder::Sensor, storage::Storage,
};

use crate::{
    Label, Memory,
    application::{Application, Wishes},
    health::Health,
    memory::CUSTOMER,
    wdga,
};

/// What the encoder is delivered with (chapter 4.1).
const NODE_ID: NodeId = match NodeId::new(wdga::Dictionary::DEFAULTS.node_id) {
    Some(node_id) => node_id,
    None => unreachable!(),
};

/// How often the position is read when no frame asks for it, in ms.
const PERIOD: u32 = 1;

/// The types of transmission that a change of the position triggers (table 8.46).
const EVENT_DRIVEN: u8 = 0xFE;

/// The node in an encoder.
pub(crate) type Slave<M> = Node<wdga::Device<Application, Memory<M>>>;

/// A WDGA: it takes frames from the bus, and gives frames.
///
/// As [`Node`], it has neither clock nor bus: the main loop hands it each frame ([`Encoder::receive`]), sends what it gives
/// ([`Encoder::poll`], until that is `None`), and may sleep until [`Encoder::poll_at`].
#[derive(Debug)]
pub struct Encoder<S, M: Storage> {
    node: Slave<M>,
    sensor: S,
    health: Health,
    /// When the position is read next.
    sample_due: Instant,
    /// When a controller that is off the bus is to return; [`Instant::NEVER`] when it is not.
    rejoin_due: Instant,
    /// The bit rate of now; [`BitRate::AUTOMATIC`] while it is listened for.
    bit_rate: BitRate,
}

impl<S: Sensor, M: Storage> Encoder<S, M> {
    /// An encoder after power-on. Whether it is a singleturn or multiturn one says the sensor's shaft.
    #[must_use]
    pub fn new(sensor: S, storage: M, label: Label) -> Self {
        let application = Application::new(sensor.shaft(), label);
        let mut device = wdga::Device::with_storage(application, Memory(storage));
        device.handlers.label(&mut device.od);
        let mut encoder = Self {
            node: Node::new(device, NODE_ID),
            sensor,
            health: Health::default(),
            sample_due: Instant::default(),
            rejoin_due: Instant::NEVER,
            bit_rate: BitRate::AUTOMATIC,
        };
        encoder.fulfil();
        encoder
    }

    /// Takes a frame from the bus.
    pub fn receive(&mut self, now: Instant, frame: &Frame) {
        // The answer is to have the position of this moment.
        self.sample(now);
        self.node.receive(now, frame);
        self.fulfil();
        self.show_bus();
    }

    /// The next frame to send at `now`; `None` when there is nothing (more) to say.
    pub fn poll(&mut self, now: Instant) -> Option<Frame> {
        if self.is_listening() {
            return None;
        }
        if now >= self.sample_due {
            self.sample(now);
        }
        let frame = self.node.poll(now);
        self.fulfil();
        frame
    }

    /// When [`Encoder::poll`] is to be called next, if no frame arrives before; `None` while the bit rate is listened for.
    #[must_use]
    pub fn poll_at(&self) -> Option<Instant> {
        if self.is_listening() {
            return None;
        }
        let node = self.node.poll_at().unwrap_or(Instant::NEVER);
        Some(node.min(self.sample_due))
    }

    /// The bit rate that the CAN controller is to have (2100h, LSS). [`BitRate::AUTOMATIC`] means that it is to listen, and
    /// neither to send nor to acknowledge, at one bit rate after another, until a frame comes that is whole; then call
    /// [`Encoder::detected`] (chapter 4.1).
    #[must_use]
    pub fn bit_rate(&self) -> BitRate {
        self.bit_rate
    }

    /// The driver has found the bus's bit rate: the encoder boots up.
    pub fn detected(&mut self, bit_rate: BitRate) {
        self.bit_rate = bit_rate;
    }

    /// Tells the state of the CAN controller, as often as the driver likes ([`Node::set_bus_state`]).
    pub fn set_bus_state(&mut self, now: Instant, state: BusState) {
        let seconds = u32::from(self.node.device().od.bus_off_auto_reset);
        if state != BusState::Off || seconds == 0 {
            self.rejoin_due = Instant::NEVER;
        } else if self.node.bus_state() != BusState::Off {
            self.rejoin_due = now.plus_millis(seconds * 1000);
        }
        self.node.set_bus_state(state);
    }

    /// Whether the controller has been off the bus for as long as 2103h says, and the driver is to take it back (chapter 7.11).
    #[must_use]
    pub fn is_to_rejoin(&self, now: Instant) -> bool {
        now >= self.rejoin_due
    }

    /// The sensor, to turn a virtual one.
    pub fn sensor(&mut self) -> &mut S {
        &mut self.sensor
    }

    /// The node: its state, its dictionary.
    #[must_use]
    pub fn node(&self) -> &Slave<M> {
        &self.node
    }

    /// The node, to change.
    pub fn node_mut(&mut self) -> &mut Slave<M> {
        &mut self.node
    }

    fn is_listening(&self) -> bool {
        self.bit_rate == BitRate::AUTOMATIC
    }

    /// Reads the sensor, and tells the PDOs.
    fn sample(&mut self, now: Instant) {
        self.sample_due = now.plus_millis(PERIOD);
        let reading = self.sensor.reading();
        let wdga::Device { od, handlers, .. } = self.node.application_mut();
        let has_moved = handlers.measurement.update(od, now, reading);
        if has_moved {
            self.send_position();
        }
        self.health.look(&mut self.node, &mut self.sensor, now);
    }

    /// Table 8.46: type FEh goes out on a change of the position, whatever it carries.
    fn send_position(&mut self) {
        let od = &self.node.device().od;
        let types = [
            od.tpdo_1_communication_transmission_type,
            od.tpdo_2_communication_transmission_type,
            od.tpdo_3_communication_transmission_type,
            od.tpdo_4_communication_transmission_type,
        ];
        for (number, transmission_type) in (1..).zip(types) {
            if transmission_type == EVENT_DRIVEN {
                self.node.trigger_tpdo(number);
            }
        }
    }

    /// Does what handlers have asked for.
    fn fulfil(&mut self) {
        let wishes = core::mem::take(&mut self.node.application_mut().handlers.wishes);
        if wishes != Wishes::default() {
            self.obey(wishes);
            self.show_bus();
        }
    }

    fn obey(&mut self, wishes: Wishes) {
        let wdga::Device { od, handlers, .. } = self.node.application_mut();
        if wishes.starts_anew {
            handlers.start(od);
        } else if wishes.measures_anew {
            handlers.measurement.configure(od);
        }
        if wishes.configures_bus {
            let node_id = NodeId::new(od.node_id).unwrap_or(NODE_ID);
            let bit_rate = BitRate::from_index(od.baud_rate);
            let stored = self.node.configure_lss(node_id, bit_rate);
            self.health.stored(&mut self.node, stored);
        }
        if wishes.saves_customer_data {
            self.health.save(&mut self.node, CUSTOMER);
        }
        if wishes.starts_anew {
            let (_, bit_rate) = self.node.configured_lss();
            // What was found by listening is still right.
            let fixed = bit_rate.filter(|rate| *rate != BitRate::AUTOMATIC);
            self.bit_rate = fixed.unwrap_or(self.bit_rate);
            self.sample_due = Instant::default();
        }
    }

    /// 2100h and 2101h read what was configured last, be it by LSS.
    fn show_bus(&mut self) {
        let (node_id, bit_rate) = self.node.configured_lss();
        let od = &mut self.node.application_mut().od;
        od.node_id = node_id.map_or(od.node_id, NodeId::get);
        od.baud_rate = bit_rate.unwrap_or(BitRate::AUTOMATIC).index();
    }
}
