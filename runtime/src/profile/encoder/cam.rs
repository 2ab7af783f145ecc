//! Cams (CiA 406, 8.2): outputs that switch at positions, eight in a channel, 6300h to 6337h.
//!
//! ```text
//! hysteresis     ├─┤                 ├─┤
//! active           ┌─────────────────┐
//!                ◀─┘ on here,        └─▶ off beyond the hysteresis, on both edges
//!               low limit          high limit
//! ```
//!
//! Positions are on a circle: a cam whose low limit is above its high limit is active across the end of the range.

use super::{distance, wrapped};

/// A cam's switch points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cam {
    /// 6310h to 6317h: the first position at which it is active. A negative one is counted back from the end of the range.
    pub low: i32,
    /// 6320h to 6327h: the last position at which it is active.
    pub high: i32,
    /// 6330h to 6337h: how far the position has to leave the cam until it is not active any more, in measuring units.
    pub hysteresis: u32,
}

impl Cam {
    /// Whether the cam is active at `position` of `range`; `was_active` says whether it was before.
    #[must_use]
    pub fn is_active(&self, was_active: bool, position: u64, range: u64) -> bool {
        let [low, high] = [self.low, self.high].map(|limit| on_circle(limit, range));
        let length = distance(low, high, range);
        let ahead = distance(low, position, range);
        if ahead <= length || !was_active {
            return ahead <= length;
        }
        // Outside: it is left behind by one edge or by the other.
        let beyond_high = ahead - length;
        let before_low = range - ahead;
        beyond_high.min(before_low) <= u64::from(self.hysteresis)
    }
}

/// A limit as a position.
fn on_circle(limit: i32, range: u64) -> u64 {
    let size = wrapped(limit.unsigned_abs().into(), range);
    if limit < 0 {
        distance(size, 0, range)
    } else {
        size
    }
}

/// The cams of a channel: which are watched, which are inverted, and what they show.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cams {
    /// Which were active, before they were inverted.
    active: u8,
}

impl Cams {
    /// None is active yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { active: 0 }
    }

    /// The cam state register (6300h) at `position` of `range`, bit 0 for the first cam. A cam that `enable` (6301h) does not
    /// name shows 0; one that `polarity` (6302h) names shows the contrary.
    pub fn update(&mut self, cams: &[Cam; 8], enable: u8, polarity: u8, position: u64, range: u64) -> u8 {
        let mut active = 0;
        for (number, cam) in cams.iter().enumerate() {
            let bit = 1 << number;
            if enable & bit != 0 && cam.is_active(self.active & bit != 0, position, range) {
                active |= bit;
            }
        }
        self.active = active;
        (active ^ polarity) & enable
    }
}
