//! The three LEDs of an encoder (manual, 3).

use lexican_runtime::led::Pattern;

/// An error counter from which on the error LED warns.
const WARNING_LIMIT: u8 = 96;

/// What the LEDs show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leds {
    /// Yellow: lit while the speed is beyond what the encoder or its limit speeds allow.
    pub device: Pattern,
    /// Green: the NMT state.
    pub run: Pattern,
    /// Red: the state of the bus.
    pub error: Pattern,
}

/// The error counters of a CAN controller.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ErrorCounters {
    /// Receive error counter.
    pub receive: u8,
    /// Transmit error counter.
    pub transmit: u8,
}

impl ErrorCounters {
    /// 1002h: the receive error counter in the lowest byte, the transmit error counter above it.
    pub(crate) const fn status(self) -> u32 {
        u32::from_le_bytes([self.receive, self.transmit, 0, 0])
    }

    /// Whether one of them has reached the warning limit.
    pub(crate) const fn warn(self) -> bool {
        self.receive >= WARNING_LIMIT || self.transmit >= WARNING_LIMIT
    }
}
