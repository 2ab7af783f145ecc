//! Speed, acceleration and jerk (6030h, 6040h, 6050h), each over the integration time.

use lexican_runtime::{Instant, profile::encoder::speed};

use crate::wdga::Dictionary;

/// What has happened since the integration time began, and what was found in the one before.
///
/// The values are those of the last whole integration time (2105h:02), and stay until the next is over.
#[derive(Clone, Debug, Default)]
pub(crate) struct Motion {
    began: Option<Instant>,
    /// Measuring units.
    traveled: i64,
    /// Measuring units a second.
    speed: i32,
    /// The same a second.
    acceleration: i32,
    is_too_fast: bool,
}

impl Motion {
    /// The shaft has turned by `way` measuring units until `now`.
    pub(crate) fn update(&mut self, od: &mut Dictionary, now: Instant, way: i64) {
        self.traveled = self.traveled.saturating_add(way);
        let began = *self.began.get_or_insert(now);
        let time = od.integration_value_speed_integration_time.max(1);
        if now < began.plus_millis(time) {
            return;
        }
        let millis = (now.as_micros() - began.as_micros()) / 1000;
        self.integrate(od, u32::try_from(millis).unwrap_or(u32::MAX));
        self.began = Some(now);
        self.traveled = 0;
    }

    /// Whether the shaft is faster than the frequency limit (2107h), in revolutions a second.
    pub(crate) const fn is_too_fast(&self) -> bool {
        self.is_too_fast
    }

    fn integrate(&mut self, od: &mut Dictionary, millis: u32) {
        let traveled = saturated(self.traveled);
        let [multiplier, divisor] = od.speed_scaling;
        let before = (self.speed, self.acceleration);
        self.speed = speed(traveled, millis, 1, 1);
        self.acceleration = speed(self.speed.saturating_sub(before.0), millis, 1, 1);
        let jerk = speed(self.acceleration.saturating_sub(before.1), millis, 1, 1);
        od.speed_value = [to_i16(speed(traveled, millis, multiplier, divisor))];
        od.acceleration_value = [to_i16(self.acceleration)];
        od.jerk_value = [to_i16(jerk)];
        self.is_too_fast = is_faster(od, traveled.unsigned_abs(), millis);
    }
}

/// Compares products, as no revolution is to be lost by dividing: 2³¹ · 1000 is below 2⁴¹, 2¹⁶ · 2³² · 2¹⁴ is 2⁶².
fn is_faster(od: &Dictionary, traveled: u32, millis: u32) -> bool {
    let limit = u64::from(od.frequency_limit) * u64::from(millis);
    u64::from(traveled) * 1000 > limit.saturating_mul(od.measuring_units_per_revolution.into())
}

fn saturated(traveled: i64) -> i32 {
    i32::try_from(traveled).unwrap_or(if traveled < 0 { i32::MIN } else { i32::MAX })
}

/// The objects are INTEGER16: beyond it, the nearest one.
fn to_i16(value: i32) -> i16 {
    i16::try_from(value).unwrap_or(if value < 0 { i16::MIN } else { i16::MAX })
}
