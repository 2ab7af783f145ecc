//! A PDO that this node sends.

use super::{cob_id, mapping::Mapping, parameter, parameter_u8, sub, Direction, Mapped};
use crate::{
    od::Device,
    wire::{CanId, Frame},
    Address, Instant,
};

/// Sent after an event, with the next SYNC.
const ACYCLIC: u8 = 0;
/// Sent with every SYNC; up to [`LAST_CYCLIC`] with every so many-th.
const FIRST_CYCLIC: u8 = 1;
const LAST_CYCLIC: u8 = 240;
/// Sampled at SYNC, sent on RTR.
const RTR_SYNCHRONOUS: u8 = 252;
/// Sent after an event; the device profile's 255 is sent so too.
const EVENT_DRIVEN: u8 = 254;

/// A TPDO: its parameters, resolved, and what there is to send.
#[derive(Clone, Copy, Debug)]
pub struct Tpdo {
    /// 1 to 512; 0 of one that is not used.
    number: u16,
    mapping: Mapping,
    /// `None` while it is not valid or has no mapping.
    id: Option<CanId>,
    /// Set when its parameters were written.
    is_stale: bool,
    allows_rtr: bool,
    /// It is to be sent.
    is_requested: bool,
    /// Of type 0: it is to be sent with the next SYNC.
    has_event: bool,
    transmission_type: u8,
    sync_start_value: u8,
    /// Whether the SYNC with that counter is still to come.
    awaits_start: bool,
    /// Of types 1 to 240: SYNCs until it is sent.
    countdown: u8,
    /// In 100 µs.
    inhibit_time: u16,
    /// In ms.
    event_timer: u16,
    inhibited_until: Instant,
    event_due: Instant,
    /// Of type 252: the values of the last SYNC.
    sample: u64,
}

impl Tpdo {
    /// One that is not used: all zero, so that it takes no place in flash.
    pub const EMPTY: Self = Self {
        number: 0,
        mapping: Mapping::EMPTY,
        id: None,
        is_stale: false,
        allows_rtr: false,
        is_requested: false,
        has_event: false,
        transmission_type: 0,
        sync_start_value: 0,
        awaits_start: false,
        countdown: 0,
        inhibit_time: 0,
        event_timer: 0,
        inhibited_until: Instant::from_micros(0),
        event_due: Instant::from_micros(0),
        sample: 0,
    };

    /// The TPDO `number`, its mapping beginning at `first` in the room.
    pub(super) fn new<D: Device>(device: &D, number: u16, first: u16) -> Self {
        Self {
            number,
            mapping: Mapping::new(device, Direction::Transmit.mapping(number), first),
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

    /// The identifier; `None` while it is not sent.
    pub(super) const fn id(&self) -> Option<CanId> {
        self.id
    }

    /// Its parameters were written.
    pub(super) fn mark(&mut self) {
        self.is_stale = self.number != 0;
    }

    /// Takes its parameters, if they were written; says so.
    pub(super) fn configure<D: Device>(&mut self, device: &D, pool: &mut [Mapped]) -> bool {
        if !self.is_stale {
            return false;
        }
        self.is_stale = false;
        let cob_id = cob_id(device, Direction::Transmit, self.number);
        let mapping = Direction::Transmit.mapping(self.number);
        self.mapping.configure(device, Direction::Transmit, mapping, pool);
        let exists = cob_id.is_valid() && self.mapping.is_active();
        self.id = cob_id.can_id().filter(|_| exists);
        self.is_requested &= exists;
        self.has_event &= exists;
        self.allows_rtr = !cob_id.has_bit_30();
        let index = Direction::Transmit.communication(self.number);
        self.transmission_type = parameter_u8(device, index, sub::TRANSMISSION_TYPE);
        self.sync_start_value = parameter_u8(device, index, sub::SYNC_START_VALUE);
        self.inhibit_time = parameter(device, index, sub::INHIBIT_TIME);
        self.event_timer = parameter(device, index, sub::EVENT_TIMER);
        if self.mapping.is_multiplexed::<D>() {
            // It is sent when there is a value to send, and then only.
            (self.transmission_type, self.event_timer, self.allows_rtr) = (EVENT_DRIVEN, 0, false);
        }
        true
    }

    /// The node became OPERATIONAL, or new parameters take effect.
    pub(super) fn start<D: Device>(&mut self, now: Instant, device: &mut D, pool: &[Mapped]) {
        self.awaits_start = self.sync_start_value != 0;
        self.countdown = self.transmission_type;
        self.restart_event_timer(now);
        if self.transmission_type == RTR_SYNCHRONOUS && self.id.is_some() {
            self.sample = self.mapping.collect(device, pool);
        }
    }

    /// The node left OPERATIONAL.
    pub(super) fn stop(&mut self) {
        self.is_requested = false;
        self.has_event = false;
        self.event_due = Instant::NEVER;
    }

    /// A SYNC came, with a counter unless that is 0; says whether the PDO is to be sent.
    pub(super) fn sync<D: Device>(&mut self, device: &mut D, pool: &[Mapped], counter: u8) -> bool {
        match self.transmission_type {
            _ if self.id.is_none() => return false,
            FIRST_CYCLIC..=LAST_CYCLIC => self.is_requested |= self.counts_down(counter),
            ACYCLIC if self.has_event => {
                self.has_event = false;
                self.is_requested = true;
            }
            RTR_SYNCHRONOUS => self.sample = self.mapping.collect(device, pool),
            _ => {}
        }
        self.is_requested
    }

    /// Counts a SYNC; whether it was the last one to wait for.
    fn counts_down(&mut self, counter: u8) -> bool {
        if self.awaits_start && counter != 0 {
            if counter != self.sync_start_value {
                return false;
            }
            self.countdown = 1;
        }
        self.awaits_start = false;
        self.countdown = self.countdown.saturating_sub(1);
        let is_last = self.countdown == 0;
        if is_last {
            self.countdown = self.transmission_type;
        }
        is_last
    }

    /// Whether it is valid, and each says itself which object it carries, in the way of `count`.
    pub(super) fn is_multiplexed<D: Device>(&self, device: &D, count: u8) -> bool {
        let index = Direction::Transmit.mapping(self.number);
        self.mapping.is_multiplexed::<D>() && self.id.is_some() && parameter_u8(device, index, 0) == count
    }

    /// Of a multiplexed one: these eight bytes are to be sent. `false` while others are.
    pub(super) fn multiplex(&mut self, word: u64) -> bool {
        let is_free = !self.is_requested;
        if is_free {
            (self.sample, self.is_requested) = (word, true);
        }
        is_free
    }

    /// An event: it is to be sent, at once or with the next SYNC. `false` for a type without events.
    pub(super) fn trigger(&mut self) -> bool {
        match self.transmission_type {
            _ if self.id.is_none() || !self.mapping.has_objects() => return false,
            ACYCLIC => self.has_event = true,
            EVENT_DRIVEN..=u8::MAX => self.is_requested = true,
            _ => return false,
        }
        true
    }

    /// It was asked for by RTR.
    pub(super) fn ask(&mut self) {
        self.is_requested |= self.allows_rtr && self.id.is_some();
    }

    /// Whether the object at `address` is mapped.
    pub(super) fn contains<D: Device>(&self, device: &D, pool: &[Mapped], address: Address) -> bool {
        self.mapping.contains(device, pool, address)
    }

    /// Whether it is to be sent, now or after its inhibit time.
    pub(super) const fn is_requested(&self) -> bool {
        self.is_requested
    }

    /// Whether its inhibit time is over.
    pub(super) fn may_be_sent(&self, now: Instant) -> bool {
        now >= self.inhibited_until
    }

    /// Forgets a synchronous transmission that missed its window.
    pub(super) fn miss(&mut self) {
        self.is_requested &= self.transmission_type > LAST_CYCLIC;
    }

    /// The frame to send.
    pub(super) fn send<D: Device>(&mut self, device: &mut D, pool: &[Mapped]) -> Option<Frame> {
        self.is_requested = false;
        let word = match self.transmission_type {
            RTR_SYNCHRONOUS => self.sample,
            _ if self.mapping.is_multiplexed::<D>() => self.sample,
            _ => self.mapping.collect(device, pool),
        };
        self.id.map(|id| Frame::from_word(id, word, self.mapping.length()))
    }

    /// Whether inhibit time and event timer are heeded.
    pub(super) const fn has_timers(&self) -> bool {
        self.transmission_type >= EVENT_DRIVEN
    }

    /// It was sent at `now`: restarts its timers.
    #[inline(never)]
    pub(super) fn restart(&mut self, now: Instant) {
        self.inhibited_until = now.plus_micros(u64::from(self.inhibit_time) * 100);
        self.restart_event_timer(now);
    }

    /// Looks at the event timer; says whether the PDO is to be sent.
    pub(super) fn expire(&mut self, now: Instant) -> bool {
        if now >= self.event_due {
            self.event_due = Instant::NEVER;
            self.is_requested = true;
        }
        self.is_requested
    }

    /// When there is something to do that there is not at `now`; [`Instant::NEVER`] if nothing.
    pub(super) fn due(&self, now: Instant) -> Instant {
        if self.is_requested && now < self.inhibited_until {
            self.event_due.min(self.inhibited_until)
        } else {
            self.event_due
        }
    }

    fn restart_event_timer(&mut self, now: Instant) {
        let runs = self.event_timer != 0 && self.has_timers() && self.id.is_some();
        self.event_due = if runs {
            now.plus_millis(u32::from(self.event_timer))
        } else {
            Instant::NEVER
        };
    }
}
