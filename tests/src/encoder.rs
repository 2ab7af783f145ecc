//! A shaft that a test turns, and a virtual WDGA around it.

use std::sync::{Arc, Mutex, MutexGuard};

use lexican_runtime::{
    AbortCode, Address, Device, Frame, Instant, Node, NodeId, od,
    profile::encoder::{Faults, Reading, Sensor, Shaft},
    storage::Storage,
};
use lexican_wdga::{Application, BitRate, Encoder, Label, Memory, Variant, wdga};

use crate::bus::{Bus, Slave};

/// A sensor in a test's hand. Clones are the same sensor.
#[derive(Clone, Debug)]
pub struct Hand(Arc<Mutex<State>>);

#[derive(Debug)]
struct State {
    shaft: Shaft,
    /// Steps from the beginning of the sensor's revolutions on.
    step: u64,
    temperature: Option<i16>,
    faults: Faults,
}

impl Hand {
    /// A sensor at step 0, at 20 °C, with nothing wrong.
    #[must_use]
    pub fn new(shaft: Shaft) -> Self {
        Self(Arc::new(Mutex::new(State {
            shaft,
            step: 0,
            temperature: Some(20),
            faults: Faults::NONE,
        })))
    }

    /// Turns the shaft by so many steps, backwards for negative ones, around the end of its revolutions too.
    ///
    /// # Panics
    /// Never: the place is on the circle.
    pub fn turn(&self, steps: i64) {
        let mut state = self.state();
        let all = i128::from(state.shaft.steps());
        let step = (i128::from(state.step) + i128::from(steps)).rem_euclid(all);
        state.step = u64::try_from(step).expect("a place on the circle");
    }

    /// Turns the shaft to so many steps from the beginning, or with a negative number from the end.
    ///
    /// # Panics
    /// Never, as [`Hand::turn`].
    pub fn put(&self, steps: i64) {
        self.state().step = 0;
        self.turn(steps);
    }

    /// Lets the temperature be this; `None` when it cannot be read.
    pub fn warm(&self, temperature: Option<i16>) {
        self.state().temperature = temperature;
    }

    /// Lets this be wrong.
    pub fn break_down(&self, faults: Faults) {
        self.state().faults = faults;
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.0.lock().expect("no test fails while it holds the sensor")
    }
}

impl Sensor for Hand {
    fn shaft(&self) -> Shaft {
        self.state().shaft
    }

    fn reading(&mut self) -> Reading {
        let state = self.state();
        let resolution = u64::from(state.shaft.resolution());
        Reading {
            turn: state.step / resolution,
            angle: u32::try_from(state.step % resolution).expect("below the resolution"),
        }
    }

    fn temperature(&mut self) -> Option<i16> {
        self.state().temperature
    }

    fn faults(&mut self) -> Faults {
        self.state().faults
    }
}

/// The generated device in a virtual WDGA.
pub type Wdga<M> = wdga::Device<Application, Memory<M>>;

/// A bus with a virtual WDGA on it.
pub type WdgaBus<M> = Bus<Wdga<M>, Encoder<Hand, M>>;

impl<S: Sensor, M: Storage> Slave<Wdga<M>> for Encoder<S, M>
where
    Wdga<M>: Device,
{
    fn receive(&mut self, now: Instant, frame: &Frame) {
        Encoder::receive(self, now, frame);
    }

    fn poll(&mut self, now: Instant) -> Option<Frame> {
        Encoder::poll(self, now)
    }

    fn poll_at(&self) -> Option<Instant> {
        Encoder::poll_at(self)
    }

    fn node(&mut self) -> &mut Node<Wdga<M>> {
        self.node_mut()
    }

    /// A shaft cannot be told where to be; a preset can. What is measured over time stays until the integration time is over.
    fn set(&mut self, address: Address, data: &[u8]) -> Result<(), AbortCode> {
        match address.index {
            0x6004 => self.node_mut().write(Address::new(0x6003, 0), data),
            0x6008 => self.node_mut().write(Address::new(0x6009, 0), data),
            _ => od::set(self.node_mut().device_mut(), address, data),
        }
    }
}

/// A multiturn WDGA that has booted with this node-ID, which it was configured to have before.
///
/// # Panics
/// When the node-ID is not 1 to 127, or it says something else.
#[must_use]
pub fn booted_wdga<M: Storage>(node_id: u8, storage: M) -> WdgaBus<M> {
    let (mut bus, _) = wdga(Variant::Multiturn, storage);
    bus.advance(0).expect("77F#00");
    if node_id != 0x7F {
        let own = NodeId::new(node_id).expect("a node-ID, 1 to 127");
        bus.node().configure_lss(own, None).expect("a memory that works");
        bus.send("000#8100")
            .expect(&format!("{:03X}#00", 0x700 + u16::from(node_id)));
    }
    bus
}

/// A WDGA that has found the bit rate of its bus, and has not booted yet; and its shaft.
#[must_use]
pub fn wdga<M: Storage>(variant: Variant, storage: M) -> (WdgaBus<M>, Hand) {
    let hand = Hand::new(lexican_wdga::shaft(variant));
    (switched_on(&hand, storage), hand)
}

/// The encoder on that shaft, switched on again.
#[must_use]
pub fn switched_on<M: Storage>(hand: &Hand, storage: M) -> WdgaBus<M> {
    let mut encoder = Encoder::new(hand.clone(), storage, Label::default());
    encoder.detected(BitRate::KBIT_500);
    Bus::with(encoder)
}
