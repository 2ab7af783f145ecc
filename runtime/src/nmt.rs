//! The NMT slave: which state the node is in, and what a command makes of it (CiA 301, 7.3.2).
//!
//! ```text
//! power-on ──▶ INITIALISING ── boot-up 700h+id#00 ──▶ PRE-OPERATIONAL ⇄ OPERATIONAL
//!                   ▲                                        ⇅            ⇅
//!                   └── reset node 81h, communication 82h ── STOPPED ─────┘
//! ```

use crate::{
    od::Reset,
    wire::nmt::{NmtCommand, NmtState},
};

/// The state machine.
#[derive(Clone, Copy, Debug)]
pub struct Slave {
    state: NmtState,
}

impl Slave {
    /// After power-on: in INITIALISING.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            state: NmtState::Initialising,
        }
    }

    /// The state.
    #[must_use]
    pub const fn state(&self) -> NmtState {
        self.state
    }

    /// Whether SDOs are served: not in INITIALISING and STOPPED (CiA 301, 7.3.2.2).
    #[must_use]
    pub const fn serves_sdo(&self) -> bool {
        matches!(self.state, NmtState::Operational | NmtState::PreOperational)
    }

    /// Whether emergency messages are sent: as SDOs, not in INITIALISING and STOPPED (CiA 301, 7.3.2.2).
    #[must_use]
    pub const fn sends_emcy(&self) -> bool {
        self.serves_sdo()
    }

    /// Whether SYNC is produced: not in INITIALISING and STOPPED (CiA 301, 7.3.2.2).
    #[must_use]
    pub const fn produces_sync(&self) -> bool {
        self.serves_sdo()
    }

    /// Whether TIME is consumed: not in INITIALISING and STOPPED (CiA 301, 7.3.2.2).
    #[must_use]
    pub const fn consumes_time(&self) -> bool {
        self.serves_sdo()
    }

    /// Whether PDOs are exchanged: in OPERATIONAL only (CiA 301, 7.3.2.2).
    #[must_use]
    pub const fn exchanges_pdos(&self) -> bool {
        matches!(self.state, NmtState::Operational)
    }

    /// Takes a command; tells what there is to reset. In INITIALISING only a reset is obeyed.
    pub fn obey(&mut self, command: NmtCommand) -> Option<Reset> {
        match command {
            NmtCommand::ResetNode => return Some(self.reset(Reset::Node)),
            NmtCommand::ResetCommunication => return Some(self.reset(Reset::Communication)),
            _ if self.state == NmtState::Initialising => {}
            NmtCommand::Start => self.state = NmtState::Operational,
            NmtCommand::Stop => self.state = NmtState::Stopped,
            NmtCommand::EnterPreOperational => self.state = NmtState::PreOperational,
        }
        None
    }

    /// The boot-up message is out: initialising is over.
    pub fn booted(&mut self) {
        self.state = NmtState::PreOperational;
    }

    /// Back to INITIALISING.
    fn reset(&mut self, reset: Reset) -> Reset {
        self.state = NmtState::Initialising;
        reset
    }
}

impl Default for Slave {
    fn default() -> Self {
        Self::new()
    }
}
