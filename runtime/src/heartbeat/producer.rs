//! The heartbeat producer (object 1017h).
//!
//! The boot-up message is the first heartbeat of a node that is configured for one. Configured later, it starts at once.

use crate::{Address, Instant};

/// 1017h: producer heartbeat time, UNSIGNED16 in ms, 0 for none.
pub const PRODUCER_HEARTBEAT_TIME: Address = Address::new(0x1017, 0x00);

/// When to send the next heartbeat.
#[derive(Clone, Copy, Debug)]
pub struct Producer {
    /// In ms; 0 while there is no heartbeat.
    period: u16,
    due: Instant,
}

impl Producer {
    /// A producer that does not run.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            period: 0,
            due: Instant::NEVER,
        }
    }

    /// The boot-up message was sent at `now`, in place of the first heartbeat.
    pub fn start(&mut self, now: Instant, period_ms: u16) {
        self.period = period_ms;
        self.due = self.after(now);
    }

    /// Takes a new period; if it is one, the next heartbeat is due at once.
    pub fn configure(&mut self, now: Instant, period_ms: u16) {
        if period_ms != self.period {
            self.period = period_ms;
            self.due = if period_ms == 0 { Instant::NEVER } else { now };
        }
    }

    /// When the next heartbeat is due; [`Instant::NEVER`] without one.
    #[must_use]
    pub const fn due(&self) -> Instant {
        self.due
    }

    /// A heartbeat is sent at `now`: sets when the next one is due. One that is late does not delay those after it,
    /// unless it is late by a whole period.
    pub fn sent(&mut self, now: Instant) {
        let next = self.after(self.due);
        self.due = if next > now { next } else { self.after(now) };
    }

    /// One period after `start`.
    fn after(&self, start: Instant) -> Instant {
        match self.period {
            0 => Instant::NEVER,
            period => start.plus_millis(u32::from(period)),
        }
    }
}

impl Default for Producer {
    fn default() -> Self {
        Self::new()
    }
}
