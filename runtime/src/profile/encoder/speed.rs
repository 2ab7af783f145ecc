//! Speed, and what comes of it (CiA 406, 8.1.9).

/// How fast a value changes, in units per second times `multiplier` over `divisor`, towards zero: of positions a speed
/// (6030h), of speeds an acceleration, of accelerations a jerk. `difference` is that of two values `millis` ms apart: the
/// integration time. Beyond 32 bits the result is the nearest number of 32 bits; a time or divisor of 0 counts as 1.
///
/// With 60 as multiplier and the measuring units of a revolution as divisor, a speed is in revolutions per minute.
#[must_use]
pub fn speed(difference: i32, millis: u32, multiplier: u16, divisor: u16) -> i32 {
    // 2³¹ · 1000 · 2¹⁶ is below 2⁵⁷, 2³² · 2¹⁶ below 2⁴⁸.
    let change = i64::from(difference) * 1000 * i64::from(multiplier);
    let time = i64::from(millis.max(1)) * i64::from(divisor.max(1));
    let speed = change / time;
    i32::try_from(speed).unwrap_or(if speed < 0 { i32::MIN } else { i32::MAX })
}
