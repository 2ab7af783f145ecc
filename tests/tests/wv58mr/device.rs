//! Encoders on a bus, and a shaft to turn.

use lexican_runtime::{Address, Frame, Instant, Node};
use lexican_tests::{
    bus::{self, Slave},
    encoder::Hand,
    line,
    memory::Memory as Cells,
};
use lexican_wv58mr::{Application, Channel, Encoder, Housing, Identity, Memory, Model, Variant, wv58mr};

/// The shaft of a variant, to turn.
pub(crate) fn shaft(variant: Variant) -> Hand {
    Hand::new(variant.shaft().expect("a shaft"))
}

pub(crate) type Device = wv58mr::Device<Application<Hand>, Memory<Cells>>;
pub(crate) type Bus<S = One> = bus::Bus<Device, S>;

/// One encoder on a bus.
pub(crate) struct One(pub(crate) Encoder<Hand, Cells>);

impl Slave<Device> for One {
    fn receive(&mut self, now: Instant, frame: &Frame) {
        self.0.receive(now, frame);
    }

    fn poll(&mut self, now: Instant) -> Option<Frame> {
        self.0.poll(now)
    }

    fn poll_at(&self) -> Option<Instant> {
        self.0.poll_at()
    }

    fn node(&mut self) -> &mut Node<Device> {
        self.0.node_mut()
    }
}

/// Both encoders of a housing on a bus; its node is the first one's.
pub(crate) struct Two(pub(crate) Housing<Hand, Cells>);

impl Slave<Device> for Two {
    fn receive(&mut self, now: Instant, frame: &Frame) {
        self.0.receive(now, frame);
    }

    fn poll(&mut self, now: Instant) -> Option<Frame> {
        self.0.poll(now)
    }

    fn poll_at(&self) -> Option<Instant> {
        self.0.poll_at()
    }

    fn node(&mut self) -> &mut Node<Device> {
        self.0.encoder_mut(Channel::First).node_mut()
    }
}

/// An empty EEPROM.
pub(crate) fn eeprom() -> Cells {
    Cells::eeprom(2048)
}

/// The first encoder of a housing just switched on, with what is in this EEPROM.
pub(crate) fn switched_on(shaft: &Hand, cells: &Cells) -> Bus {
    let encoder = Encoder::with_storage(shaft.clone(), Identity::default(), cells.clone());
    Bus::with(One(encoder.expect("a sensor of this encoder")))
}

/// The same, in PRE-OPERATIONAL, as node 1.
#[track_caller]
pub(crate) fn booted(shaft: &Hand) -> Bus {
    let mut bus = switched_on(shaft, &eeprom());
    bus.advance(0).expect("701#00");
    bus
}

/// A 12 bit multiturn encoder as delivered, in PRE-OPERATIONAL, and its shaft.
#[track_caller]
pub(crate) fn delivered() -> (Bus, Hand) {
    let hand = shaft(Variant::MultiTurn12);
    (booted(&hand), hand)
}

/// The same in OPERATIONAL.
#[track_caller]
pub(crate) fn operational() -> (Bus, Hand) {
    let (mut bus, shaft) = delivered();
    bus.send("000#0101").silence();
    (bus, shaft)
}

/// Both encoders of a housing, 12 bit multiturn, with EEPROMs and shafts of their own, just switched on.
pub(crate) fn housing(shafts: &[Hand; 2]) -> Bus<Two> {
    let [first, second] = shafts.clone().map(|shaft| (shaft, eeprom()));
    let housing = Housing::new(Model::Wv58mr, 4711, first, second);
    bus::Bus::with(Two(housing.expect("sensors of this encoder")))
}

/// Talks to node 1 as an SDO client.
pub(crate) trait Client {
    /// Writes a value of one to four bytes; its answer is to be awaited.
    fn write(&mut self, index: u16, sub: u8, value: &[u8]) -> &mut Self;
    /// Writes, and the encoder takes it.
    fn set(&mut self, index: u16, sub: u8, value: &[u8]) -> &mut Self;
    /// Writes, and the encoder refuses with this abort code.
    fn refuse(&mut self, index: u16, sub: u8, value: &[u8], code: u32) -> &mut Self;
    /// Reads a number.
    fn get(&mut self, index: u16, sub: u8) -> u32;
}

impl<S: Slave<Device>> Client for Bus<S> {
    #[track_caller]
    fn write(&mut self, index: u16, sub: u8, value: &[u8]) -> &mut Self {
        let command = 0x2F - 4 * (u8::try_from(value.len()).expect("one to four bytes") - 1);
        let [low, high] = index.to_le_bytes();
        let mut data = [command, low, high, sub, 0, 0, 0, 0];
        data[4..4 + value.len()].copy_from_slice(value);
        self.send(&format!("601#{}", line::hex(&data)))
    }

    #[track_caller]
    fn set(&mut self, index: u16, sub: u8, value: &[u8]) -> &mut Self {
        let [low, high] = index.to_le_bytes();
        self.write(index, sub, value)
            .expect(&format!("581#60{low:02X}{high:02X}{sub:02X}00000000"))
    }

    #[track_caller]
    fn refuse(&mut self, index: u16, sub: u8, value: &[u8], code: u32) -> &mut Self {
        let [low, high] = index.to_le_bytes();
        let code = line::hex(&code.to_le_bytes());
        self.write(index, sub, value)
            .expect(&format!("581#80{low:02X}{high:02X}{sub:02X}{code}"))
    }

    #[track_caller]
    fn get(&mut self, index: u16, sub: u8) -> u32 {
        let value = self.node().read(Address::new(index, sub)).expect("such a number");
        value.to_u32()
    }
}
