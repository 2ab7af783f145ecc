//! SYNC (CiA 301, 7.2.5 and objects 1005h, 1006h, 1007h, 1019h): consumer and producer.
//!
//! A consumer keeps what the objects say, to know a SYNC at once; what it means is the PDOs' business. SYNC is
//! produced in PRE-OPERATIONAL and OPERATIONAL, the first one a period after the producer starts; the counter then is 1.

use crate::{
    od::{self, Device},
    wire::{self, CanId, CobId, Frame},
    AbortCode, Address, Instant,
};

/// 1005h: COB-ID SYNC, UNSIGNED32; bit 30 set for a producer.
pub const COB_ID_SYNC: Address = Address::new(0x1005, 0x00);
/// 1006h: communication cycle period, UNSIGNED32 in µs, 0 for none.
pub const CYCLE_PERIOD: Address = Address::new(0x1006, 0x00);
/// 1007h: synchronous window length, UNSIGNED32 in µs, 0 for none.
pub const WINDOW_LENGTH: Address = Address::new(0x1007, 0x00);
/// 1019h: synchronous counter overflow value, UNSIGNED8: 0 for no counter, 2 to 240.
pub const COUNTER_OVERFLOW: Address = Address::new(0x1019, 0x00);

/// What a SYNC looks like, and how long it lasts.
#[derive(Clone, Copy, Debug, Default)]
pub struct Consumer {
    id: Option<CanId>,
    counts: bool,
    /// In µs; 0 for no end.
    window: u32,
}

impl Consumer {
    /// Looks at the objects.
    #[must_use]
    pub fn new<D: Device>(device: &D) -> Self {
        Self {
            id: cob_id(device).and_then(CobId::can_id),
            counts: od::parameter(device, COUNTER_OVERFLOW) != 0,
            window: od::parameter(device, WINDOW_LENGTH),
        }
    }

    /// The identifier of SYNC; `None` for a device without 1005h.
    #[must_use]
    pub const fn id(&self) -> Option<CanId> {
        self.id
    }

    /// The counter in a SYNC, 0 where the network does not count; `None` when the frame has another length than that asks for.
    #[must_use]
    pub fn counter(&self, frame: &Frame) -> Option<u8> {
        wire::sync::parse(frame, self.counts)
    }

    /// Until when synchronous PDOs go with the SYNC of `now`.
    #[must_use]
    pub fn window(&self, now: Instant) -> Instant {
        match self.window {
            0 => Instant::NEVER,
            micros => now.plus_micros(u64::from(micros)),
        }
    }
}

/// Refuses what a client may not write to the objects of this service; says nothing of others.
///
/// # Errors
/// * [`AbortCode::INVALID_VALUE`] for a 1005h that changes bits 0 to 29 while bit 30 is and stays set, or has an identifier
///   that [`CobId::check`] refuses; for a 1019h of 1 or above 240
/// * [`AbortCode::DEVICE_STATE`] for any 1019h while 1006h is not 0
pub fn before_write<D: Device>(device: &D, address: Address, value: u32) -> Result<(), AbortCode> {
    match address {
        COB_ID_SYNC => check_cob_id(cob_id(device).unwrap_or_default(), CobId(value)),
        COUNTER_OVERFLOW => check_overflow(od::parameter(device, CYCLE_PERIOD), value),
        _ => Ok(()),
    }
}

fn check_cob_id(old: CobId, new: CobId) -> Result<(), AbortCode> {
    if old.has_bit_30() && new.has_bit_30() && !new.has_identifier_of(old) {
        return Err(AbortCode::INVALID_VALUE);
    }
    new.check()
}

fn check_overflow(period: u32, overflow: u32) -> Result<(), AbortCode> {
    match overflow {
        1 | 241.. => Err(AbortCode::INVALID_VALUE),
        _ if period != 0 => Err(AbortCode::DEVICE_STATE),
        _ => Ok(()),
    }
}

fn cob_id<D: Device>(device: &D) -> Option<CobId> {
    od::configured(device, COB_ID_SYNC).map(CobId)
}

/// When to send the next SYNC.
#[derive(Clone, Copy, Debug)]
pub struct Producer {
    /// In µs; 0 while there is none.
    period: u32,
    due: Instant,
    /// Of the last SYNC; 0 before the first.
    counter: u8,
}

impl Producer {
    /// A producer that does not run.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            period: 0,
            due: Instant::NEVER,
            counter: 0,
        }
    }

    /// Looks at the objects; `allowed` says whether the NMT state lets SYNC out.
    pub fn configure<D: Device>(&mut self, now: Instant, device: &D, allowed: bool) {
        let produces = allowed && cob_id(device).is_some_and(CobId::has_bit_30);
        let period = if produces {
            od::parameter(device, CYCLE_PERIOD)
        } else {
            0
        };
        if period != self.period {
            *self = Self::new();
            self.period = period;
            self.due = self.after(now);
        }
    }

    /// When the next SYNC is due; [`Instant::NEVER`] without one.
    #[must_use]
    pub const fn due(&self) -> Instant {
        self.due
    }

    /// The SYNC that is due at `now`, and its counter (0 without one); sets when the next one is.
    pub fn send<D: Device>(&mut self, now: Instant, device: &D) -> Option<(Frame, u8)> {
        let next = self.after(self.due);
        self.due = if next > now { next } else { self.after(now) };
        let counter = self.count(device);
        Some((
            wire::sync::emit(cob_id(device)?.can_id()?, counter),
            counter.unwrap_or(0),
        ))
    }

    /// The next counter, 1 after the overflow value; `None` where 1019h asks for none.
    fn count<D: Device>(&mut self, device: &D) -> Option<u8> {
        let overflow = od::parameter(device, COUNTER_OVERFLOW);
        self.counter = if u32::from(self.counter) < overflow {
            self.counter + 1
        } else {
            1
        };
        (overflow != 0).then_some(self.counter)
    }

    fn after(&self, start: Instant) -> Instant {
        match self.period {
            0 => Instant::NEVER,
            period => start.plus_micros(u64::from(period)),
        }
    }
}

impl Default for Producer {
    fn default() -> Self {
        Self::new()
    }
}
