//! The two LEDs of a device (CiA 303-3): what they show, and when they are lit.
//!
//! ```text
//!                 0    200   400   600   800  1000  …ms
//! blinking        ■■■■■░░░░░■■■■■░░░░░■■■■■░░░░░
//! single flash    ■■■■■░░░░░░░░░░░░░░░░░░░░░░░░░■■■■■
//! double flash    ■■■■■░░░░░■■■■■░░░░░░░░░░░░░░░░░░░░░░░░░■■■■■
//! ```
//!
//! Pure functions: the driver asks [`Pattern::is_lit`] as often as it likes, 50 ms at the latest for one that flickers.

use crate::{wire::emcy::Emergency, BusState, NmtState};

/// What an LED shows. Flickering is 10 Hz, blinking 2.5 Hz; flashes last 200 ms, 200 ms apart, with 1000 ms between groups.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Pattern {
    /// Never lit.
    Off,
    /// Always lit.
    On,
    /// 50 ms lit, 50 ms not.
    Flickering,
    /// 200 ms lit, 200 ms not.
    Blinking,
    /// Once in 1200 ms.
    SingleFlash,
    /// Twice in 1600 ms.
    DoubleFlash,
    /// Three times in 2000 ms.
    TripleFlash,
    /// Four times in 2400 ms.
    QuadrupleFlash,
}

impl Pattern {
    /// Whether it is lit `millis` ms after it began. The clock may be any that counts ms and may wrap; that of the run LED
    /// and that of the error LED are to be the same one.
    #[must_use]
    pub const fn is_lit(self, millis: u32) -> bool {
        match self {
            Self::Off => false,
            Self::On => true,
            Self::Flickering => millis % 100 < 50,
            Self::Blinking => millis % 400 < 200,
            Self::SingleFlash => flashes(millis, 1),
            Self::DoubleFlash => flashes(millis, 2),
            Self::TripleFlash => flashes(millis, 3),
            Self::QuadrupleFlash => flashes(millis, 4),
        }
    }
}

/// So many flashes, then a pause of 1000 ms.
const fn flashes(millis: u32, count: u32) -> bool {
    let phase = millis % (count * 400 + 800);
    phase < count * 400 && phase % 400 < 200
}

/// What the green run LED shows in an NMT state; `is_configured_by_lss` while the bit rate is looked for or LSS is at work.
#[must_use]
pub const fn run(state: NmtState, is_configured_by_lss: bool) -> Pattern {
    match state {
        _ if is_configured_by_lss => Pattern::Flickering,
        NmtState::Initialising => Pattern::Off,
        NmtState::PreOperational => Pattern::Blinking,
        NmtState::Operational => Pattern::On,
        NmtState::Stopped => Pattern::SingleFlash,
    }
}

/// What the red error LED shows: the worst of what is wrong. `stands` says whether the error with this emergency code
/// stands: [`Node::is_error_standing`](crate::Node::is_error_standing).
#[must_use]
pub fn error(bus_state: BusState, stands: impl Fn(u16) -> bool, is_configured_by_lss: bool) -> Pattern {
    match bus_state {
        BusState::Off => Pattern::On,
        _ if is_configured_by_lss => Pattern::Flickering,
        _ if stands(Emergency::RPDO_TIMEOUT) => Pattern::QuadrupleFlash,
        _ if stands(Emergency::UNEXPECTED_SYNC_LENGTH) => Pattern::TripleFlash,
        _ if stands(Emergency::LIFE_GUARD) => Pattern::DoubleFlash,
        BusState::Passive => Pattern::SingleFlash,
        BusState::Active => Pattern::Off,
    }
}

#[cfg(test)]
mod tests {
    use super::{error, run, Pattern};
    use crate::{BusState, Emergency, NmtState};

    /// When a pattern changes in its first 2600 ms, beginning lit.
    fn changes(pattern: Pattern) -> impl Iterator<Item = u32> {
        (1..2600).filter(move |&millis| pattern.is_lit(millis) != pattern.is_lit(millis - 1))
    }

    #[test]
    fn flashes_last_200_ms_and_groups_are_a_second_apart() {
        assert!(changes(Pattern::SingleFlash).eq([200, 1200, 1400, 2400]));
        assert!(changes(Pattern::DoubleFlash).eq([200, 400, 600, 1600, 1800, 2000, 2200]));
        assert!(changes(Pattern::TripleFlash).eq([200, 400, 600, 800, 1000, 2000, 2200, 2400]));
        assert!(changes(Pattern::QuadrupleFlash).eq([200, 400, 600, 800, 1000, 1200, 1400, 2400]));
        assert!(changes(Pattern::Blinking).take(3).eq([200, 400, 600]));
        assert!(changes(Pattern::Flickering).take(3).eq([50, 100, 150]));
        assert!(Pattern::On.is_lit(u32::MAX) && !Pattern::Off.is_lit(0));
    }

    #[test]
    fn the_run_led_shows_the_nmt_state() {
        assert_eq!(run(NmtState::PreOperational, false), Pattern::Blinking);
        assert_eq!(run(NmtState::Operational, false), Pattern::On);
        assert_eq!(run(NmtState::Stopped, false), Pattern::SingleFlash);
        assert_eq!(run(NmtState::Stopped, true), Pattern::Flickering);
    }

    #[test]
    fn the_error_led_shows_the_worst_error() {
        let all = |_: u16| true;
        let none = |_: u16| false;
        assert_eq!(error(BusState::Off, all, true), Pattern::On);
        assert_eq!(error(BusState::Active, none, false), Pattern::Off);
        assert_eq!(error(BusState::Passive, none, false), Pattern::SingleFlash);
        assert_eq!(
            error(BusState::Passive, |code| code == Emergency::LIFE_GUARD, false),
            Pattern::DoubleFlash
        );
        assert_eq!(error(BusState::Passive, all, false), Pattern::QuadrupleFlash);
    }
}
