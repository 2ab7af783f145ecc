//! One of the two encoders: a node, its sensor, and what ties them together.

use lexican_runtime::{
    Address, BusState, Emergency, Frame, Instant, Node, NodeId,
    led::{self, Pattern},
    lss::{self, BitRate},
    profile::encoder::Sensor,
    storage::{NoStorage, Storage},
};

use crate::{
    WrongSensor,
    application::{Application, Causes, Orders},
    baud_rate,
    bus_error::BusError,
    led::{ErrorCounters, Leds},
    memory::{HISTORY, Memory},
    variant::{Identity, Variant},
    wv58mr::Device,
};

/// How often the sensor is read, in µs.
const SAMPLE_PERIOD: u64 = 1000;
/// Bit 7 of 1001h: a sensor error.
const MANUFACTURER: u8 = 0x80;
/// 1800h:05.
const EVENT_TIMER: Address = Address::new(0x1800, 0x05);

/// An encoder on its bus, to be driven as a [`Node`] is: it is handed each frame that arrives ([`Encoder::receive`]), sends
/// what it has to say ([`Encoder::poll`], until there is nothing more), and may sleep until [`Encoder::poll_at`].
pub struct Encoder<S: Sensor, M: Storage = NoStorage> {
    node: Node<Device<Application<S>, Memory<M>>>,
    sampled: Option<Instant>,
    /// What was reported last.
    causes: Causes,
    /// The error history as it is stored.
    history: History,
    counters: ErrorCounters,
    /// The bit rate of 5F0Ah:02 counts from the next reset on.
    adopts_bit_rate: bool,
}

/// 1003h: the number of errors, and the errors.
type History = (u8, [u32; 8]);

impl<S: Sensor> Encoder<S> {
    /// An encoder without an EEPROM: 1010h and 1011h refuse.
    ///
    /// # Errors
    /// [`WrongSensor`] for a sensor that none of the encoders has.
    pub fn new(sensor: S, identity: Identity) -> Result<Self, WrongSensor> {
        Self::with_storage(sensor, identity, NoStorage)
    }
}

impl<S: Sensor, M: Storage> Encoder<S, M> {
    /// An encoder after power-on, with what its EEPROM holds; its first [`Encoder::poll`] gives the boot-up message. It has
    /// the node-ID that is stored, or that of its channel as delivered.
    ///
    /// # Errors
    /// [`WrongSensor`] for a sensor that none of the encoders has.
    pub fn with_storage(sensor: S, identity: Identity, storage: M) -> Result<Self, WrongSensor> {
        let node_id = identity.channel.node_id().ok_or(WrongSensor)?;
        let application = Application::new(sensor, identity)?;
        let mut node = Node::new(Device::with_storage(application, Memory(storage)), node_id);
        let Device { od, handlers, .. } = node.device_mut();
        handlers.start(od);
        let history = (od.predefined_error_field_number_of_errors, od.predefined_error_field);
        let mut encoder = Self {
            node,
            sampled: None,
            causes: Causes::default(),
            history,
            counters: ErrorCounters::default(),
            adopts_bit_rate: false,
        };
        encoder.show_node_id();
        Ok(encoder)
    }

    /// Takes a frame from the bus.
    pub fn receive(&mut self, now: Instant, frame: &Frame) {
        self.sample(now);
        self.node.receive(now, frame);
        self.settle();
    }

    /// The next frame to send at `now`; `None` when there is nothing (more) to say.
    pub fn poll(&mut self, now: Instant) -> Option<Frame> {
        self.sample(now);
        let frame = self.node.poll(now);
        self.settle();
        frame
    }

    /// When [`Encoder::poll`] is to be called next, if no frame arrives before: every millisecond, as the sensor is read.
    #[must_use]
    pub fn poll_at(&self) -> Option<Instant> {
        let sample = self
            .sampled
            .map_or_else(Instant::default, |at| at.plus_micros(SAMPLE_PERIOD));
        self.node.poll_at().map(|due| due.min(sample)).or(Some(sample))
    }

    /// Reads the sensor, unless it was read at this very time, and reports what is wrong and what is not any more.
    fn sample(&mut self, now: Instant) {
        if self.sampled == Some(now) {
            return;
        }
        self.sampled = Some(now);
        let Device { od, handlers, .. } = self.node.application_mut();
        let causes = handlers.sample(od, now);
        if causes != self.causes {
            self.report(causes);
        }
    }

    /// Raises the emergencies of new causes, and clears those of causes that are gone.
    fn report(&mut self, causes: Causes) {
        for (cause, code) in Causes::ALL {
            if causes.has(cause) == self.causes.has(cause) {
                continue;
            }
            if causes.has(cause) {
                self.node.raise_emergency(Emergency::new(code, MANUFACTURER));
            } else {
                self.node.clear_emergency(code);
            }
        }
        self.causes = causes;
    }

    /// Does what a frame or a timer has asked for.
    fn settle(&mut self) {
        let Orders {
            event_timer,
            node_id,
            bit_rate,
            saves,
            restores,
            was_reset,
        } = self.node.application_mut().handlers.take_orders();
        if let Some(millis) = event_timer {
            // It is within its type, and not refused.
            let _ = self.node.write(EVENT_TIMER, &millis.to_le_bytes());
        }
        if node_id.is_some() || bit_rate.is_some() {
            self.configure(node_id, bit_rate);
        }
        if restores {
            self.deliver();
        }
        if saves || restores {
            // A client was told already that its save is done; what failed now fails again at its next one.
            let _ = self.node.store_lss();
        }
        if was_reset {
            self.after_reset();
        }
        self.show_node_id();
        self.keep_history();
    }
}

impl<S: Sensor, M: Storage> Encoder<S, M> {
    /// 5F0Ah was written: it counts from the next reset on, as what an LSS master configures.
    fn configure(&mut self, node_id: Option<NodeId>, bit_rate: Option<u8>) {
        let (old_node_id, old_bit_rate) = self.node.configured_lss();
        let bit_rate = bit_rate.and_then(baud_rate::bit_rate);
        self.adopts_bit_rate |= bit_rate.is_some();
        if let Some(node_id) = node_id.or(old_node_id) {
            self.node.prepare_lss(node_id, bit_rate.or(old_bit_rate));
        }
    }

    /// Node-ID and bit rate as delivered, from the next reset on.
    fn deliver(&mut self) {
        self.configure(
            self.identity().channel.node_id(),
            Some(baud_rate::number(baud_rate::DELIVERED)),
        );
    }

    /// The node has forgotten its errors; what is still wrong is reported with the next sample.
    fn after_reset(&mut self) {
        self.causes = Causes::default();
        if core::mem::take(&mut self.adopts_bit_rate) {
            self.node.adopt_bit_rate();
        }
    }

    /// 5F0Ah shows what was configured last, by LSS too.
    fn show_node_id(&mut self) {
        let (node_id, bit_rate) = self.node.configured_lss();
        let node_id = node_id.map_or(0, NodeId::get);
        let number = baud_rate::number(bit_rate.unwrap_or(baud_rate::DELIVERED));
        self.node.application_mut().od.node_id_and_baud_rate = [node_id, number];
    }

    /// Stores the error history when it has changed.
    fn keep_history(&mut self) {
        let od = &self.node.device().od;
        let history = (od.predefined_error_field_number_of_errors, od.predefined_error_field);
        if history != self.history {
            self.history = history;
            // Without an EEPROM, or with one that fails, it lasts until power-off.
            let _ = self.node.save(HISTORY);
        }
    }

    /// Which of the encoders it is.
    #[must_use]
    pub fn variant(&self) -> Variant {
        self.node.device().handlers.variant()
    }

    /// What it was given when it was made.
    #[must_use]
    pub fn identity(&self) -> Identity {
        self.node.device().handlers.identity()
    }

    /// The node.
    #[must_use]
    pub const fn node(&self) -> &Node<Device<Application<S>, Memory<M>>> {
        &self.node
    }

    /// The node, for what its driver tells it ([`Node::set_bus_state`]), and for tests.
    pub fn node_mut(&mut self) -> &mut Node<Device<Application<S>, Memory<M>>> {
        &mut self.node
    }

    /// The sensor.
    pub fn sensor_mut(&mut self) -> &mut S {
        self.node.application_mut().handlers.sensor_mut()
    }

    /// The bit rate that the CAN controller is to have: what is stored or was activated, else 500 kbit/s.
    #[must_use]
    pub fn bit_rate(&self) -> BitRate {
        self.node.bit_rate().unwrap_or(baud_rate::DELIVERED)
    }

    /// Tells the state and the error counters of the CAN controller, as often as the driver likes: 1002h shows the counters,
    /// and emergency messages tell what is new, 8120h for error passive and 8140h after the bus was off.
    pub fn set_bus_state(&mut self, state: BusState, counters: ErrorCounters) {
        self.counters = counters;
        self.node.application_mut().od.manufacturer_status_register = counters.status();
        self.node.set_bus_state(state);
        self.keep_history();
    }

    /// The CAN controller has seen an error on the bus: 5000h ranks them.
    pub fn count_bus_error(&mut self, error: BusError) {
        let Device { od, handlers, .. } = self.node.application_mut();
        handlers.bus_errors.count(error);
        od.can_bus_error_diagnosis = handlers.bus_errors.ranking();
    }

    /// What the LEDs show.
    #[must_use]
    pub fn leds(&self) -> Leds {
        let is_configured = self.node.lss_state() == lss::State::Configuration;
        let stands = |code| self.node.is_error_standing(code);
        let error = match led::error(self.node.bus_state(), stands, is_configured) {
            Pattern::Off if self.counters.warn() => Pattern::SingleFlash,
            pattern => pattern,
        };
        let is_too_fast = self.node.device().od.warnings != 0;
        Leds {
            device: if is_too_fast { Pattern::On } else { Pattern::Off },
            run: led::run(self.node.state(), is_configured),
            error,
        }
    }
}
