//! The EMCY producer (CiA 301, 7.2.7 and objects 1001h, 1003h, 1014h, 1015h).
//!
//! ```text
//! error free ── raise: message, 1001h, 1003h ──▶ error ── clear of the last one: 0000h ──▶ error free
//!                                                 │  ▲  another is raised: its message
//!                                                 └──┘  one of several is cleared: 0000h with the register of the others
//! ```
//!
//! What CiA 301 leaves open, this producer does so:
//!
//! * An error is known by its code; one that stands already is not reported again. So an application may raise it in every
//!   turn of its loop, as long as the cause is there.
//! * Messages that may not be sent yet (1015h, STOPPED) wait; of more than [`WAITING`] the oldest are dropped.
//! * A reset forgets all errors. What is still wrong is to be raised again.
//! * The additional information of 1003h is the first two bytes of the manufacturer.

mod history;
mod queue;

use queue::Queue;

use crate::{
    od::{self, Device},
    wire::{emcy::Emergency, CobId, Frame},
    AbortCode, Address, Instant,
};

/// 1001h: error register, UNSIGNED8.
pub const ERROR_REGISTER: Address = Address::new(0x1001, 0x00);
/// 1014h: COB-ID EMCY, UNSIGNED32, bit 31 set for none.
pub const COB_ID_EMCY: Address = Address::new(0x1014, 0x00);
/// 1015h: inhibit time EMCY, UNSIGNED16 in 100 µs.
pub const INHIBIT_TIME_EMCY: Address = Address::new(0x1015, 0x00);

/// How many errors may stand at once.
pub const STANDING: usize = 8;
/// How many messages may wait.
pub const WAITING: usize = queue::CAPACITY;

/// Which errors stand, and what of them is still to be told.
#[derive(Clone, Debug)]
pub struct Producer {
    standing: [Standing; STANDING],
    queue: Queue,
    /// Before it no message may be sent (1015h).
    inhibited_until: Instant,
    /// When a message that waits for the inhibit time may be sent; [`Instant::NEVER`] without one.
    due: Instant,
}

/// An error that stands; with the code [`Emergency::ERROR_RESET`], none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Standing {
    code: u16,
    register: u8,
}

impl Standing {
    const NONE: Self = Self {
        code: Emergency::ERROR_RESET,
        register: 0,
    };
}

impl Producer {
    /// A producer that knows of no error.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            standing: [Standing::NONE; STANDING],
            queue: Queue::new(),
            inhibited_until: Instant::from_micros(0),
            due: Instant::NEVER,
        }
    }

    /// An error has occurred: it goes into 1001h, 1003h and a message. `false`, and nothing has changed, when it stands
    /// already, when [`STANDING`] others do, or when its code is 0000h.
    pub fn raise<D: Device>(&mut self, device: &mut D, emergency: Emergency) -> bool {
        let code = emergency.code;
        if code == Emergency::ERROR_RESET || self.find(code).is_some() {
            return false;
        }
        // Bit 0, generic error, is in any error (CiA 301, 7.5.2.2).
        let register = emergency.register | 0x01;
        let Some(free) = self.find(Emergency::ERROR_RESET) else {
            return false;
        };
        *free = Standing { code, register };
        history::push(device, emergency);
        self.tell(device, emergency);
        true
    }

    /// The error `code` is gone: 1001h and a message with error code 0000h say what is left. `false` when it did not stand.
    pub fn clear<D: Device>(&mut self, device: &mut D, code: u16) -> bool {
        let Some(place) = self.find(code).filter(|place| **place != Standing::NONE) else {
            return false;
        };
        *place = Standing::NONE;
        self.tell(device, Emergency::new(Emergency::ERROR_RESET, 0));
        true
    }

    /// Forgets all errors and messages, after a reset. A 1001h that was not set here stays as it is.
    pub fn reset<D: Device>(&mut self, device: &mut D) {
        let had_error = self.standing.iter().any(|error| *error != Standing::NONE);
        *self = Self::new();
        if had_error {
            self.show_register(device);
        }
    }

    /// Whether the error `code` stands.
    #[must_use]
    pub fn is_standing(&self, code: u16) -> bool {
        code != Emergency::ERROR_RESET && self.standing.iter().any(|error| error.code == code)
    }

    /// Whether a message waits.
    #[must_use]
    pub const fn has_message(&self) -> bool {
        !self.queue.is_empty()
    }

    /// When a message that waits for the inhibit time may be sent; [`Instant::NEVER`] without one.
    #[must_use]
    pub const fn due(&self) -> Instant {
        self.due
    }

    /// The inhibit time that [`Producer::due`] waited for is over.
    pub fn wake(&mut self) {
        self.due = Instant::NEVER;
    }

    /// The message to send at `now`, if one waits and the inhibit time is over. All are dropped when 1014h is not valid.
    pub fn send<D: Device>(&mut self, now: Instant, device: &D) -> Option<Frame> {
        let Some(id) = cob_id(device).filter(|id| id.is_valid()).and_then(CobId::can_id) else {
            self.queue = Queue::new();
            self.due = Instant::NEVER;
            return None;
        };
        self.due = self.inhibited_until;
        if now < self.inhibited_until {
            return None;
        }
        let inhibit_time = od::parameter(device, INHIBIT_TIME_EMCY);
        self.inhibited_until = now.plus_micros(u64::from(inhibit_time) * 100);
        self.due = Instant::NEVER;
        self.queue.pop().map(|message| Frame::full(id, message))
    }

    /// Shows what stands, in 1001h and in a message.
    fn tell<D: Device>(&mut self, device: &mut D, emergency: Emergency) {
        let register = self.show_register(device);
        if cob_id(device).is_some_and(CobId::is_valid) {
            self.queue.push(Emergency { register, ..emergency }.emit());
        }
    }

    /// The error `code`, or with [`Emergency::ERROR_RESET`] the first free place.
    #[inline(never)]
    fn find(&mut self, code: u16) -> Option<&mut Standing> {
        self.standing.iter_mut().find(|place| place.code == code)
    }

    /// Sets 1001h to the bits of all that stands; gives them.
    fn show_register<D: Device>(&self, device: &mut D) -> u8 {
        let register = self.standing.iter().fold(0, |bits, error| bits | error.register);
        // A device without 1001h shows it in its messages only.
        let _ = od::set(device, ERROR_REGISTER, &[register]);
        register
    }
}

impl Default for Producer {
    fn default() -> Self {
        Self::new()
    }
}

/// Refuses what a client may not write to the objects of this service; says nothing of others.
///
/// # Errors
/// [`AbortCode::INVALID_VALUE`]
/// * for 1003h:00 other than 0,
/// * for a 1014h that is valid before and after, and changes bits 0 to 29; has bit 30 set; or an identifier that
///   [`CobId::check`] refuses.
pub fn before_write<D: Device>(device: &D, address: Address, value: u32) -> Result<(), AbortCode> {
    match address {
        history::COUNT if value != 0 => Err(AbortCode::INVALID_VALUE),
        COB_ID_EMCY => check_cob_id(cob_id(device).unwrap_or_default(), CobId(value)),
        _ => Ok(()),
    }
}

/// What a write that was let through brings about: 1003h:00 := 0 empties the history.
pub fn after_write<D: Device>(device: &mut D, address: Address) {
    if address == history::COUNT {
        history::clear(device);
    }
}

fn check_cob_id(old: CobId, new: CobId) -> Result<(), AbortCode> {
    if new.has_bit_30() {
        return Err(AbortCode::INVALID_VALUE);
    }
    new.check_change(old)
}

/// 1014h; `None` for a device without it, which sends no emergencies.
fn cob_id<D: Device>(device: &D) -> Option<CobId> {
    od::configured(device, COB_ID_EMCY).map(CobId)
}
