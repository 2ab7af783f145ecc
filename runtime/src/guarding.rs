//! Node guarding and life guarding (CiA 301, 7.2.8.3.2.1 and objects 100Ch, 100Dh): the NMT master asks for the state by a
//! remote frame; a node that is not asked for its life time knows that it is alone.
//!
//! ```text
//! 701#R1 ─▶   ◀─ 701#7F      PRE-OPERATIONAL; bit 7 toggles
//! 701#R1 ─▶   ◀─ 701#FF
//! ```
//!
//! A node that produces heartbeats (1017h) is not guarded: CiA 301 allows only one of both at a time.

use crate::{
    od::{self, Device},
    wire::nmt::NmtState,
    Address, Instant,
};

/// 100Ch: guard time, UNSIGNED16 in ms, 0 for none.
pub const GUARD_TIME: Address = Address::new(0x100C, 0x00);
/// 100Dh: life time factor, UNSIGNED8, 0 for no life guarding.
pub const LIFE_TIME_FACTOR: Address = Address::new(0x100D, 0x00);

/// The guarded side.
#[derive(Clone, Copy, Debug)]
pub struct Slave {
    /// Bit 7 of the next answer.
    toggle: bool,
    is_alone: bool,
    /// When the life time ends; [`Instant::NEVER`] before the first request.
    due: Instant,
}

impl Slave {
    /// A node that was not asked yet.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            toggle: false,
            is_alone: false,
            due: Instant::NEVER,
        }
    }

    /// The master asks: the byte to answer with.
    pub fn answer<D: Device>(&mut self, now: Instant, device: &D, state: NmtState) -> u8 {
        let toggle = u8::from(self.toggle) << 7;
        self.toggle = !self.toggle;
        self.is_alone = false;
        self.due = match life_time(device) {
            0 => Instant::NEVER,
            millis => now.plus_millis(millis),
        };
        state.number() | toggle
    }

    /// Ends a life time that 100Ch and 100Dh do not ask for any more.
    pub fn configure<D: Device>(&mut self, device: &D) {
        if life_time(device) == 0 {
            self.due = Instant::NEVER;
            self.is_alone = false;
        }
    }

    /// Looks at the life time.
    pub fn expire(&mut self, now: Instant) {
        if now >= self.due {
            self.due = Instant::NEVER;
            self.is_alone = true;
        }
    }

    /// Whether the master has stopped asking.
    #[must_use]
    pub const fn is_alone(&self) -> bool {
        self.is_alone
    }

    /// When [`Slave::expire`] has something to do; [`Instant::NEVER`] while no life time runs.
    #[inline]
    #[must_use]
    pub const fn due(&self) -> Instant {
        self.due
    }
}

impl Default for Slave {
    fn default() -> Self {
        Self::new()
    }
}

/// In ms; 0 for none.
fn life_time<D: Device>(device: &D) -> u32 {
    let [guard_time, factor] = [GUARD_TIME, LIFE_TIME_FACTOR].map(|address| od::parameter(device, address));
    guard_time.saturating_mul(factor)
}
