//! Filtering of positions: more stable, at the cost of following more slowly.

use super::{add, distance, way};

/// Fractions of a step that a filter tells apart.
const FRACTIONS: i64 = 256;

/// A filter of the first order on a circle: with each position it goes a part of the way there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Filter {
    /// Where it is, unless it has seen no position yet: whole steps, and fractions of one.
    place: Option<(u64, i64)>,
}

impl Filter {
    /// A filter that has seen no position yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { place: None }
    }

    /// Forgets what was seen: the next position is taken as it is.
    pub fn reset(&mut self) {
        self.place = None;
    }

    /// Takes `position` of `range`; gives the filtered one, the nearest whole step. Of the way to `position` it goes the part
    /// 1 ÷ 2ˢ, where s is `strength`, 0 to 7: with 0 the whole way, which is no filter.
    pub fn update(&mut self, position: u64, range: u64, strength: u8) -> u64 {
        if strength == 0 {
            self.place = Some((position, 0));
            return position;
        }
        let strength = strength.min(7);
        let (whole, fraction) = self.place.unwrap_or((position, 0));
        let ahead = way(whole, position, range).saturating_mul(FRACTIONS) - fraction;
        let fraction = fraction + (ahead >> strength);
        let whole = moved(whole, fraction.div_euclid(FRACTIONS), range);
        let fraction = fraction.rem_euclid(FRACTIONS);
        self.place = Some((whole, fraction));
        moved(whole, i64::from(fraction >= FRACTIONS / 2), range)
    }
}

/// The place so many steps ahead, or behind.
fn moved(from: u64, steps: i64, range: u64) -> u64 {
    let size = steps.unsigned_abs() % range;
    if steps < 0 {
        distance(size, from, range)
    } else {
        add(from, size, range)
    }
}
