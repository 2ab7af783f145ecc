//! 6030h: how fast the raw position (600Ch) changes.

use lexican_runtime::{Instant, profile::encoder};

use crate::variant::RESOLUTION;

/// How many times the speed is worked out in one integration time.
const PARTS: usize = 10;

/// The way of the shaft over the integration time, in steps per ms.
///
/// The way is that since the integration time before; it is worked out anew ten times in each, so that a change is seen
/// soon.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Speed {
    /// The last raw position, once there is one.
    raw: Option<u32>,
    /// All steps since power-on; it wraps.
    way: i32,
    marks: [Mark; PARTS],
    /// The oldest of the marks.
    oldest: usize,
}

/// Where the shaft was at a time.
#[derive(Clone, Copy, Debug)]
struct Mark {
    at: Instant,
    way: i32,
}

/// 6031h: how a speed is worked out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Parameters {
    /// In ms.
    pub(crate) integration_time: u16,
    pub(crate) multiplier: u16,
    pub(crate) divisor: u16,
}

impl Speed {
    pub(crate) const fn new() -> Self {
        let nowhere = Mark {
            at: Instant::from_micros(0),
            way: 0,
        };
        Self {
            raw: None,
            way: 0,
            marks: [nowhere; PARTS],
            oldest: 0,
        }
    }

    /// Takes the raw position, of `steps` that there are; gives the speed when it is worked out anew.
    pub(crate) fn update(&mut self, now: Instant, raw: u32, steps: u32, parameters: Parameters) -> Option<i16> {
        let Some(last) = self.raw.replace(raw) else {
            self.marks = [Mark { at: now, way: 0 }; PARTS];
            return None;
        };
        self.way = self.way.wrapping_add(way(last, raw, steps));
        let newest = (self.oldest + PARTS - 1) % PARTS;
        let since = self.marks.get(newest)?.at;
        let part = u64::from(parameters.integration_time) * 1000 / PARTS as u64;
        if now.as_micros() < since.as_micros().saturating_add(part) {
            return None;
        }
        let new = Mark { at: now, way: self.way };
        let old = core::mem::replace(self.marks.get_mut(self.oldest)?, new);
        self.oldest = (self.oldest + 1) % PARTS;
        Some(speed(old, new, parameters))
    }
}

/// The shorter way from one raw position to the next; a single-turn sensor does not see more than half a revolution.
fn way(last: u32, raw: u32, steps: u32) -> i32 {
    let steps = steps.max(RESOLUTION);
    let forward = if raw >= last { raw - last } else { steps - last + raw };
    let way = if forward <= steps / 2 {
        i64::from(forward)
    } else {
        i64::from(forward) - i64::from(steps)
    };
    i32::try_from(way).unwrap_or(0)
}

/// Steps per ms times multiplier over divisor; what is beyond INTEGER16 is its end.
fn speed(old: Mark, new: Mark, parameters: Parameters) -> i16 {
    let millis = (new.at.as_micros() - old.at.as_micros()) / 1000;
    // The profile's function gives units per second: of a time in thousandths, units per ms.
    let thousandths = u32::try_from(millis.saturating_mul(1000)).unwrap_or(u32::MAX);
    let way = new.way.wrapping_sub(old.way);
    let speed = encoder::speed(way, thousandths, parameters.multiplier, parameters.divisor);
    i16::try_from(speed).unwrap_or(if speed < 0 { i16::MIN } else { i16::MAX })
}

#[cfg(test)]
mod tests {
    use lexican_runtime::Instant;

    use super::{Parameters, Speed};

    const STEPS: u32 = 16_384 * 16;

    fn after(steps_per_ms: i64, millis: i64) -> i16 {
        let parameters = Parameters {
            integration_time: 100,
            multiplier: 1,
            divisor: 1,
        };
        let mut meter = Speed::new();
        let mut speed = 0;
        for at in 0..=millis {
            let raw = u32::try_from((at * steps_per_ms).rem_euclid(i64::from(STEPS))).unwrap();
            let now = Instant::from_millis(at.unsigned_abs());
            speed = meter.update(now, raw, STEPS, parameters).unwrap_or(speed);
        }
        speed
    }

    #[test]
    fn a_steady_speed_is_exact_across_the_end_of_the_range_in_both_directions() {
        // 16,384 steps per ms are 60,000 revolutions a minute.
        for speed in [1, -1, 273, -273, 16_384, -16_384] {
            assert_eq!(i64::from(after(speed, 1000)), speed);
        }
    }

    #[test]
    fn the_first_speeds_are_those_since_power_on() {
        assert_eq!(after(1000, 9), 0);
        assert_eq!(after(1000, 10), 1000);
    }

    #[test]
    fn a_speed_beyond_16_bits_is_the_greatest_one() {
        assert_eq!(after(40_000, 200), i16::MAX);
        assert_eq!(after(-40_000, 200), i16::MIN);
    }
}
