//! The state machine of the slave.

use super::{BitRate, BitRates};
use crate::{
    od::{self, Device, Reset},
    storage::Settings,
    wire::lss::{Bound, FastScan, Part, Request, Response},
    Address, Instant, NodeId,
};

/// In which state the slave is (CiA 305, 5.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum State {
    /// It waits to be selected.
    Waiting,
    /// It can be configured.
    Configuration,
}

/// What a request asks of the node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reaction {
    /// Nothing.
    Nothing,
    /// To send this answer.
    Answer(Response),
    /// To store [`Slave::pending_node_id`] and [`Slave::pending_bit_rate`], and to answer how that went.
    Store,
    /// To be silent until the bit rate is switched.
    Silence,
    /// To boot up with [`Slave::pending_node_id`].
    BootUp,
}

/// What is configured, and who is asked.
#[derive(Clone, Debug)]
pub struct Slave {
    state: State,
    /// How many messages of a selection or identification have matched; the latter's count from [`IDENTIFYING`] on.
    matched: u8,
    /// Which part of the LSS address a fastscan asks for next.
    scanned: u8,
    pending: NodeId,
    persistent: NodeId,
    bit_rate: Option<BitRate>,
    pending_bit_rate: Option<BitRate>,
    /// In ms; of the switch that is under way.
    switch_delay: u16,
    has_switched: bool,
    /// When a switch delay is over; [`Instant::NEVER`] without one.
    due: Instant,
}

/// [`Slave::matched`] of an identification of which no message has come yet.
const IDENTIFYING: u8 = 0x10;

const DONE: u8 = 0;
const REFUSED: u8 = 1;

impl Slave {
    /// A slave that starts with this node-ID and bit rate; the latter is `None` while it is the application's choice.
    pub(crate) const fn new(node_id: NodeId, bit_rate: Option<BitRate>) -> Self {
        Self {
            state: State::Waiting,
            matched: 0,
            scanned: 0,
            pending: node_id,
            persistent: node_id,
            bit_rate,
            pending_bit_rate: bit_rate,
            switch_delay: 0,
            has_switched: false,
            due: Instant::NEVER,
        }
    }

    /// The state.
    #[must_use]
    pub const fn state(&self) -> State {
        self.state
    }

    /// The node-ID that was configured last; `None` when it was 255.
    #[must_use]
    pub const fn pending_node_id(&self) -> Option<NodeId> {
        self.pending.configured()
    }

    /// What is to be stored.
    pub(crate) const fn settings(&self) -> Settings {
        Settings {
            node_id: self.pending,
            bit_rate: self.pending_bit_rate,
        }
    }

    /// The bit rate that was configured last.
    #[must_use]
    pub const fn pending_bit_rate(&self) -> Option<BitRate> {
        self.pending_bit_rate
    }

    /// The bit rate that the CAN controller is to have; `None` while nobody has configured one.
    #[must_use]
    pub const fn bit_rate(&self) -> Option<BitRate> {
        self.bit_rate
    }

    /// When a switch delay is over; [`Instant::NEVER`] without one.
    #[inline]
    #[must_use]
    pub const fn due(&self) -> Instant {
        self.due
    }

    /// Whether the bit rate is being switched: nothing may be sent.
    #[must_use]
    pub fn is_switching(&self) -> bool {
        self.due != Instant::NEVER
    }

    /// The application gives the node another node-ID, for good.
    pub(crate) fn set_node_id(&mut self, node_id: NodeId) {
        self.pending = node_id;
        self.persistent = node_id;
    }

    /// The application configures both, as a master would.
    pub(crate) fn configure_both(&mut self, node_id: NodeId, bit_rate: Option<BitRate>) {
        self.pending = node_id;
        self.pending_bit_rate = bit_rate;
    }

    /// The bit rate that was configured becomes the active one; gives it, if it is another one.
    pub(crate) fn adopt_bit_rate(&mut self) -> Option<BitRate> {
        let before = core::mem::replace(&mut self.bit_rate, self.pending_bit_rate);
        self.bit_rate.filter(|_| self.bit_rate != before)
    }

    /// What was pending is stored.
    pub(crate) fn stored(&mut self) {
        self.persistent = self.pending;
    }

    /// The node is reset; gives the node-ID that is active from now on.
    pub(crate) fn reset(&mut self, reset: Reset) -> NodeId {
        if reset == Reset::Node {
            self.pending = self.persistent;
        }
        self.wait();
        self.pending
    }

    /// Looks at the switch delay. `now` is not before [`Slave::due`].
    pub(crate) fn expire(&mut self, now: Instant) {
        if self.has_switched {
            self.due = Instant::NEVER;
        } else {
            self.has_switched = true;
            self.bit_rate = self.pending_bit_rate;
            self.due = now.plus_millis(u32::from(self.switch_delay));
        }
    }

    /// Takes a request to the node with the active node-ID `active`.
    pub(crate) fn receive<D: Device>(
        &mut self,
        now: Instant,
        device: &D,
        active: NodeId,
        request: Request,
    ) -> Reaction {
        match request {
            Request::SwitchGlobal(0) => self.switch_to_waiting(active),
            Request::SwitchGlobal(1) => {
                self.state = State::Configuration;
                Reaction::Nothing
            }
            Request::Identify(bound, number) => self.identify(device, bound, number),
            Request::IdentifyNonConfigured if self.is_without_node_id(active) => {
                Reaction::Answer(Response::NonConfigured)
            }
            _ if self.state == State::Configuration => self.configure(now, device, active, request),
            Request::SwitchSelective(part, number) => self.select(device, part, number),
            Request::FastScan(scan) if self.is_without_node_id(active) => self.scan(device, scan),
            _ => Reaction::Nothing,
        }
    }

    /// The services of the configuration state.
    fn configure<D: Device>(&mut self, now: Instant, device: &D, active: NodeId, request: Request) -> Reaction {
        Reaction::Answer(match request {
            Request::ConfigureNodeId(number) => Response::NodeIdConfigured(self.configure_node_id(number)),
            Request::ConfigureBitTiming { table, index } => {
                Response::BitTimingConfigured(self.configure_bit_rate(device.bit_rates(), table, index))
            }
            Request::ActivateBitTiming(switch_delay) => {
                self.switch_delay = switch_delay;
                self.has_switched = false;
                self.due = now.plus_millis(u32::from(switch_delay));
                return Reaction::Silence;
            }
            Request::Store => return Reaction::Store,
            Request::Inquire(part) => Response::Identity(part, identity(device, part)),
            Request::InquireNodeId => Response::NodeId(active.get()),
            _ => return Reaction::Nothing,
        })
    }

    fn configure_node_id(&mut self, number: u8) -> u8 {
        let node_id = NodeId::new(number).or((number == NodeId::NONE.get()).then_some(NodeId::NONE));
        let Some(node_id) = node_id else { return REFUSED };
        self.pending = node_id;
        DONE
    }

    fn configure_bit_rate(&mut self, supported: BitRates, table: u8, index: u8) -> u8 {
        let bit_rate = BitRate::from_index(index).filter(|bit_rate| table == 0 && supported.has(*bit_rate));
        if bit_rate.is_none() {
            return REFUSED;
        }
        self.pending_bit_rate = bit_rate;
        DONE
    }

    fn switch_to_waiting(&mut self, active: NodeId) -> Reaction {
        self.wait();
        if active == NodeId::NONE && self.pending != NodeId::NONE {
            return Reaction::BootUp;
        }
        Reaction::Nothing
    }

    fn wait(&mut self) {
        self.state = State::Waiting;
        self.matched = 0;
        self.scanned = 0;
    }

    fn select<D: Device>(&mut self, device: &D, part: Part, number: u32) -> Reaction {
        let is_last = part == Part::SerialNumber;
        if !self.goes_on(0, part.number(), number == identity(device, part)) || !is_last {
            return Reaction::Nothing;
        }
        self.state = State::Configuration;
        Reaction::Answer(Response::Selected)
    }

    fn identify<D: Device>(&mut self, device: &D, bound: Bound, number: u32) -> Reaction {
        let order = number.cmp(&identity(device, bound.part()));
        let holds = match bound {
            Bound::VendorId | Bound::ProductCode => order.is_eq(),
            Bound::RevisionLow | Bound::SerialLow => order.is_le(),
            Bound::RevisionHigh | Bound::SerialHigh => order.is_ge(),
        };
        if self.goes_on(IDENTIFYING, bound.number(), holds) && bound == Bound::SerialHigh {
            return Reaction::Answer(Response::Identified);
        }
        Reaction::Nothing
    }

    /// Whether the sequence that begins at `first` goes on with its message `number`, which `matches` or not.
    #[inline(never)] // Asked in two places.
    fn goes_on(&mut self, first: u8, number: u8, matches: bool) -> bool {
        let is_next = number == 0 || self.matched == first + number;
        let goes_on = is_next && matches;
        self.matched = if goes_on { first + number + 1 } else { 0 };
        goes_on
    }

    /// A question of a fastscan (CiA 305, 6.5.3): the slaves whose bits are other ones are silent, and drop out when the
    /// master has found all bits of a part.
    fn scan<D: Device>(&mut self, device: &D, scan: FastScan) -> Reaction {
        if scan.bit_check == FastScan::START {
            self.scanned = 0;
            return Reaction::Answer(Response::Identified);
        }
        if scan.bit_check > 31 || scan.sub > 3 || scan.next > 3 || scan.sub != self.scanned {
            return Reaction::Nothing;
        }
        let difference = scan.id_number ^ identity(device, Part::from_number(scan.sub));
        if difference >> scan.bit_check != 0 {
            return Reaction::Nothing;
        }
        self.scanned = scan.next;
        if scan.bit_check == 0 && scan.next < scan.sub {
            self.state = State::Configuration;
        }
        Reaction::Answer(Response::Identified)
    }

    fn is_without_node_id(&self, active: NodeId) -> bool {
        active == NodeId::NONE && self.pending == NodeId::NONE
    }
}

/// A part of the LSS address; 0 for a device without that sub-index.
#[inline(never)]
fn identity<D: Device>(device: &D, part: Part) -> u32 {
    od::parameter(device, Address::new(0x1018, part.number() + 1))
}
