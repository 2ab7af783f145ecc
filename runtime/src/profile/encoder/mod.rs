//! Encoders (CiA 406): from what the sensor says to what the objects say.
//!
//! ```text
//! turn, angle ─▶ Position   code sequence, scaling, preset        6000h to 6004h, 6008h, 6009h, 6501h, 6502h, 6509h
//!                   ├─▶ Filter   the way there in parts
//!                   ├─▶ speed    difference over time, scaled      6030h, and twice more: acceleration, jerk
//!                   ├─▶ Cams     eight switch points               6300h to 6337h
//!                   └─▶ area     work area                         6400h to 6402h
//! ```
//!
//! Integer arithmetic throughout; exact for every parameter that the standard allows, and nothing overflows.

mod area;
mod cam;
mod filter;
mod position;
mod sensor;
mod speed;

pub use area::{area, Area, OUT_OF_RANGE, OVERFLOW, UNDERFLOW};
pub use cam::{Cam, Cams};
pub use filter::Filter;
pub use position::{Parameters, Position, Reading, Shaft};
pub use sensor::{Faults, Sensor};
pub use speed::speed;

/// The shorter way from `from` to `to` on a circle of `range` steps, negative for backwards; both are on it. Half of the
/// circle is a way forwards; what is longer than an `i64` is as long as the longest one.
#[must_use]
pub fn way(from: u64, to: u64, range: u64) -> i64 {
    let ahead = distance(from, to, range);
    let behind = range - ahead;
    if behind < ahead {
        i64::try_from(behind).map_or(i64::MIN, |behind| -behind)
    } else {
        i64::try_from(ahead).unwrap_or(i64::MAX)
    }
}

/// `a + b` on a circle of `range` steps; both are on it.
const fn add(a: u64, b: u64, range: u64) -> u64 {
    let gap = range - b;
    if a >= gap {
        a - gap
    } else {
        a + b
    }
}

/// What is left of `value` on a circle of `range` steps; a place on it, as nearly all are, costs no division.
const fn wrapped(value: u64, range: u64) -> u64 {
    if value < range {
        value
    } else {
        value % range
    }
}

/// How far `to` is ahead of `from` on a circle of `range` steps; both are on it.
const fn distance(from: u64, to: u64, range: u64) -> u64 {
    if to >= from {
        to - from
    } else {
        range - from + to
    }
}

/// `a * b` on a circle of `range` steps, for products beyond 64 bits too.
const fn multiply(a: u64, b: u64, range: u64) -> u64 {
    if let Some(product) = a.checked_mul(b) {
        return product % range;
    }
    let (mut double, mut rest, mut sum) = (a % range, b, 0);
    while rest != 0 {
        if rest & 1 == 1 {
            sum = add(sum, double, range);
        }
        double = add(double, double, range);
        rest >>= 1;
    }
    sum
}
