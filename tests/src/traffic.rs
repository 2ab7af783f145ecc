//! Traffic made of any bytes: frames, time and what an application does, for a node that must take all of it.
//!
//! Fuzzers and property tests both bring bytes; here they become steps. Most steps are near to what a network does, since bytes
//! taken as frames would seldom be for the node at all.

use lexican_runtime::{BusState, CanId, Device, Emergency, Frame, Instant, Node, NodeId};

/// The node-ID of the nodes that traffic is made for.
pub const NODE_ID: u8 = 4;

/// More frames than a node has to say at one moment: an SDO block of 127 segments, all PDOs, and what else there is.
const MOST_AT_ONCE: usize = 2000;

/// One thing that happens.
#[derive(Clone, Debug)]
pub enum Step {
    /// A frame comes from the bus.
    Frame(Frame),
    /// So many µs pass.
    Wait(u32),
    /// The application raises an emergency with this code.
    Raise(u16),
    /// The application clears an emergency.
    Clear(u16),
    /// The application triggers a TPDO.
    Trigger(u16),
    /// The controller's state changes.
    Bus(BusState),
}

/// The steps that `bytes` stand for.
#[must_use]
pub fn steps(bytes: &[u8]) -> Vec<Step> {
    let mut bytes = Bytes(bytes.iter());
    std::iter::from_fn(|| step(&mut bytes)).collect()
}

/// Bytes that are used up; 0 when they are.
struct Bytes<'a>(std::slice::Iter<'a, u8>);

impl Bytes<'_> {
    fn byte(&mut self) -> u8 {
        self.0.next().copied().unwrap_or(0)
    }

    fn short(&mut self) -> u16 {
        u16::from_le_bytes([self.byte(), self.byte()])
    }

    fn eight(&mut self) -> [u8; 8] {
        std::array::from_fn(|_| self.byte())
    }
}

fn step(bytes: &mut Bytes<'_>) -> Option<Step> {
    let kind = *bytes.0.next()?;
    Some(match kind {
        0..=0x6F => Step::Frame(request(bytes)),
        0x70..=0x8F => Step::Frame(Frame::full(CanId::sdo_request(node_id()), bytes.eight())),
        0x90..=0x9F => Step::Frame(data(0x000, &[command(bytes.byte()), bytes.byte() % 6])),
        0xA0..=0xAF => Step::Frame(data(0x080, bytes.eight().get(..usize::from(kind & 1)).unwrap_or(&[]))),
        0xB0..=0xBF => Step::Frame(data(0x700 + u32::from(bytes.byte() % 16), &[bytes.byte()])),
        0xC0..=0xC7 => Step::Frame(remote(bytes.short())),
        0xC8..=0xD7 => Step::Frame(Frame::full(lss_master(), bytes.eight())),
        0xD8..=0xDF => Step::Frame(any(bytes)),
        0xE0..=0xF3 => Step::Wait(u32::from(bytes.short()) << (kind & 7)),
        0xF4..=0xF6 => Step::Raise(bytes.short()),
        0xF7..=0xF9 => Step::Clear(bytes.short()),
        0xFA..=0xFD => Step::Trigger(u16::from(bytes.byte())),
        _ => Step::Bus(match bytes.byte() % 3 {
            0 => BusState::Active,
            1 => BusState::Passive,
            _ => BusState::Off,
        }),
    })
}

/// An SDO request about an object that devices have.
fn request(bytes: &mut Bytes<'_>) -> Frame {
    const COMMANDS: [u8; 16] = [
        0x40, 0x40, 0x23, 0x2B, 0x2F, 0x2B, 0x21, 0x20, 0x60, 0x70, 0x80, 0xA0, 0xA4, 0xC2, 0xC6, 0xA3,
    ];
    const INDICES: [u16; 32] = [
        0x1000, 0x1001, 0x1003, 0x1005, 0x1006, 0x1007, 0x1008, 0x1010, 0x1011, 0x1012, 0x1014, 0x1015, 0x1016, 0x1017,
        0x1018, 0x1019, 0x1020, 0x1029, 0x100C, 0x100D, 0x1200, 0x1201, 0x1400, 0x1600, 0x1800, 0x1801, 0x1A00, 0x1A01,
        0x1F80, 0x6000, 0x6003, 0x6004,
    ];
    let command = COMMANDS[usize::from(bytes.byte() & 15)];
    let [i0, i1] = INDICES[usize::from(bytes.byte() & 31)].to_le_bytes();
    let sub = bytes.byte() & 15;
    let value = std::array::from_fn::<_, 4, _>(|_| bytes.byte());
    let [v0, v1, v2, v3] = match value {
        [0, index, sub, _] => [0x20, sub & 1, index & 7, 0x60],
        [1, low, _, _] => [low, 0x01, 0x00, 0x80],
        [2, ..] => *b"save",
        [3, ..] => *b"load",
        value => value,
    };
    Frame::full(CanId::sdo_request(node_id()), [command, i0, i1, sub, v0, v1, v2, v3])
}

fn command(byte: u8) -> u8 {
    [0x01, 0x01, 0x02, 0x80, 0x81, 0x82, 0x00, byte][usize::from(byte & 7)]
}

fn remote(short: u16) -> Frame {
    let id = if short & 1 == 0 {
        0x700 + u32::from(NODE_ID)
    } else {
        u32::from(short & 0x7FF)
    };
    Frame::remote(standard(id), 1).expect("one byte")
}

fn any(bytes: &mut Bytes<'_>) -> Frame {
    let number = u32::from(bytes.short());
    let id = if number & 0x8000 == 0 {
        standard(number & 0x7FF)
    } else {
        extended(number)
    };
    let length = usize::from(bytes.byte() % 9);
    Frame::new(id, bytes.eight().get(..length).unwrap_or(&[])).expect("up to eight bytes")
}

fn data(id: u32, data: &[u8]) -> Frame {
    Frame::new(standard(id), data).expect("up to eight bytes")
}

fn lss_master() -> CanId {
    standard(0x7E5)
}

fn standard(number: u32) -> CanId {
    CanId::standard(number).expect("eleven bits")
}

fn extended(number: u32) -> CanId {
    CanId::extended(number).expect("29 bits")
}

fn node_id() -> NodeId {
    NodeId::new(NODE_ID).expect("1 to 127")
}

/// What a node sends in `steps`, each frame with its time in µs.
///
/// # Panics
/// When the node does what none may do whatever happens to it: talk without end, ask to be called at once and then say nothing,
/// or fail to answer a client after all.
#[must_use]
pub fn play<D: Device>(device: D, steps: &[Step]) -> Vec<(u64, Frame)> {
    let mut player = Player {
        node: Node::new(device, node_id()),
        now: Instant::from_millis(1),
        sent: Vec::new(),
    };
    player.collect();
    for step in steps {
        player.take(step);
    }
    player.must_answer();
    player.sent
}

struct Player<D: Device> {
    node: Node<D>,
    now: Instant,
    sent: Vec<(u64, Frame)>,
}

impl<D: Device> Player<D> {
    fn take(&mut self, step: &Step) {
        match *step {
            Step::Frame(frame) => self.node.receive(self.now, &frame),
            Step::Wait(micros) => self.wait(u64::from(micros)),
            Step::Raise(code) => _ = self.node.raise_emergency(Emergency::new(code, 0x81)),
            Step::Clear(code) => _ = self.node.clear_emergency(code),
            Step::Trigger(number) => _ = self.node.trigger_tpdo(number),
            Step::Bus(state) => self.node.set_bus_state(state),
        }
        self.collect();
    }

    /// Lets time pass, as a main loop that sleeps until the node asks to be called.
    fn wait(&mut self, micros: u64) {
        let end = self.now.plus_micros(micros);
        let mut calls = 0;
        while let Some(due) = self.node.poll_at().filter(|due| *due <= end) {
            self.now = due.max(self.now);
            self.collect();
            calls += 1;
            // A timer of 100 µs may run out so often, no other.
            if calls > 1000 {
                break;
            }
        }
        self.now = end;
    }

    fn collect(&mut self) {
        let before = self.sent.len();
        while let Some(frame) = self.node.poll(self.now) {
            self.sent.push((self.now.as_micros(), frame));
            assert!(self.sent.len() - before < MOST_AT_ONCE, "the node talks without end");
        }
        let due = self.node.poll_at();
        assert!(
            due.is_none_or(|due| due > self.now),
            "the node has nothing to say, and asks to be called at once"
        );
    }

    /// After all that, a reset makes it a node that serves its clients.
    fn must_answer(&mut self) {
        self.take(&Step::Bus(BusState::Active));
        // LSS may have taken its node-ID away, or silenced it for as long as a bit rate takes to change.
        self.wait(200_000_000);
        for request in [[0x04, 1], [0x11, NODE_ID], [0x04, 0]] {
            let [command, argument] = request;
            self.take(&Step::Frame(Frame::full(
                lss_master(),
                [command, argument, 0, 0, 0, 0, 0, 0],
            )));
        }
        self.take(&Step::Frame(data(0x000, &[0x81, 0x00])));
        self.wait(1_000_000);
        let before = self.sent.len();
        // LSS may have taken its node-ID.
        let Some(node_id) = self.node.node_id() else { return };
        let request = CanId::sdo_request(node_id);
        self.take(&Step::Frame(Frame::full(request, [0x40, 0x00, 0x10, 0, 0, 0, 0, 0])));
        let answer = CanId::sdo_response(node_id);
        assert!(
            self.sent.iter().skip(before).any(|(_, frame)| frame.id() == answer),
            "the node does not answer any more"
        );
    }
}
