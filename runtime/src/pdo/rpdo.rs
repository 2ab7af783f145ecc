//! A PDO that this node receives.

use super::{cob_id, mapping::Mapping, mpdo, parameter, parameter_u8, sub, Direction, Mapped};
use crate::{
    od::Device,
    wire::{CanId, Frame},
    Instant, NodeId,
};

/// The last transmission type that takes effect with SYNC.
const LAST_SYNCHRONOUS: u8 = 240;

/// An RPDO: its parameters, resolved, and what has come.
#[derive(Clone, Copy, Debug)]
pub struct Rpdo {
    /// 1 to 512; 0 of one that is not used.
    number: u16,
    mapping: Mapping,
    /// `None` while it is not valid or has no mapping.
    id: Option<CanId>,
    /// Set when its parameters were written.
    is_stale: bool,
    /// The last one was too short.
    is_short: bool,
    /// None came within the event timer.
    is_late: bool,
    transmission_type: u8,
    /// In ms.
    event_timer: u16,
    event_due: Instant,
    /// What takes effect with the next SYNC.
    waiting: Option<u64>,
}

impl Rpdo {
    /// One that is not used: all zero, so that it takes no place in flash.
    pub const EMPTY: Self = Self {
        number: 0,
        mapping: Mapping::EMPTY,
        id: None,
        is_stale: false,
        is_short: false,
        is_late: false,
        transmission_type: 0,
        event_timer: 0,
        event_due: Instant::from_micros(0),
        waiting: None,
    };

    /// The RPDO `number`, its mapping beginning at `first` in the room.
    pub(super) fn new<D: Device>(device: &D, number: u16, first: u16) -> Self {
        Self {
            number,
            mapping: Mapping::new(device, Direction::Receive.mapping(number), first),
            ..Self::EMPTY
        }
    }

    pub(super) const fn number(&self) -> u16 {
        self.number
    }

    /// Where in the room the next mapping begins.
    pub(super) const fn end(&self) -> u16 {
        self.mapping.end()
    }

    /// The identifier; `None` while it is not received.
    pub(super) const fn id(&self) -> Option<CanId> {
        self.id
    }

    /// Whether the last one was too short.
    pub(super) const fn is_short(&self) -> bool {
        self.is_short
    }

    /// Whether none came within the event timer.
    pub(super) const fn is_late(&self) -> bool {
        self.is_late
    }

    /// Its parameters were written.
    pub(super) fn mark(&mut self) {
        self.is_stale = self.number != 0;
    }

    /// Takes its parameters, if they were written.
    pub(super) fn configure<D: Device>(&mut self, device: &D, pool: &mut [Mapped]) {
        if !self.is_stale {
            return;
        }
        self.stop();
        self.is_stale = false;
        let cob_id = cob_id(device, Direction::Receive, self.number);
        let mapping = Direction::Receive.mapping(self.number);
        self.mapping.configure(device, Direction::Receive, mapping, pool);
        let exists = cob_id.is_valid() && self.mapping.is_active();
        self.id = cob_id.can_id().filter(|_| exists);
        let index = Direction::Receive.communication(self.number);
        self.transmission_type = parameter_u8(device, index, sub::TRANSMISSION_TYPE);
        self.event_timer = parameter(device, index, sub::EVENT_TIMER);
    }

    /// The node left OPERATIONAL, or its parameters change: what was wrong is so no more, what waits is dropped. The event
    /// timer starts with the next PDO.
    pub(super) fn stop(&mut self) {
        self.waiting = None;
        self.is_short = false;
        self.is_late = false;
        self.event_due = Instant::NEVER;
    }

    /// A multiplexed PDO came.
    pub(super) fn receive_multiplexed<D: Device>(&self, device: &mut D, node_id: NodeId, frame: &Frame) {
        let count = parameter_u8(device, Direction::Receive.mapping(self.number), 0);
        mpdo::receive(device, node_id, count, frame.word());
    }

    /// Whether each says itself which object it carries.
    pub(super) fn is_multiplexed<D: Device>(&self) -> bool {
        self.mapping.is_multiplexed::<D>()
    }

    /// The PDO came at `now`.
    pub(super) fn receive<D: Device>(&mut self, now: Instant, device: &mut D, pool: &[Mapped], frame: &Frame) {
        self.is_short = frame.length() < usize::from(self.mapping.length());
        if self.is_short {
            return;
        }
        self.is_late = false;
        if self.event_timer != 0 {
            self.event_due = now.plus_millis(u32::from(self.event_timer));
        }
        if self.is_synchronous() {
            self.waiting = Some(frame.word());
        } else {
            self.mapping.distribute(device, pool, frame.word());
        }
    }

    /// A SYNC came: what waits takes effect.
    pub(super) fn sync<D: Device>(&mut self, device: &mut D, pool: &[Mapped]) {
        if let Some(word) = self.waiting.take() {
            self.mapping.distribute(device, pool, word);
        }
    }

    /// Whether it takes effect with SYNC.
    pub(super) const fn is_synchronous(&self) -> bool {
        self.transmission_type <= LAST_SYNCHRONOUS
    }

    /// Looks at the event timer.
    pub(super) fn expire(&mut self, now: Instant) {
        if now >= self.event_due {
            self.event_due = Instant::NEVER;
            self.is_late = true;
        }
    }

    /// When the event timer runs out.
    pub(super) const fn due(&self) -> Instant {
        self.event_due
    }
}
