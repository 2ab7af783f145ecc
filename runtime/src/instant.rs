//! Time, as the caller's clock counts it.

/// A point in time, in microseconds since some start that the caller chose.
///
/// 64 bits do not wrap in the life of a device.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Instant(u64);

impl Instant {
    /// Where a timer points that does not run: later than any clock gets.
    pub const NEVER: Self = Self(u64::MAX);

    /// `micros` µs after the clock's start; the very last of them counts as the one before it, so that no clock reaches
    /// [`Instant::NEVER`].
    #[must_use]
    pub const fn from_micros(micros: u64) -> Self {
        match micros {
            u64::MAX => Self(u64::MAX - 1),
            micros => Self(micros),
        }
    }

    /// `millis` ms after the clock's start.
    #[must_use]
    pub const fn from_millis(millis: u64) -> Self {
        Self::from_micros(millis.saturating_mul(1000))
    }

    /// Microseconds since the clock's start.
    #[must_use]
    pub const fn as_micros(self) -> u64 {
        self.0
    }

    /// The point `micros` µs later.
    #[must_use]
    pub const fn plus_micros(self, micros: u64) -> Self {
        Self(self.0.saturating_add(micros))
    }

    /// The point `millis` ms later.
    #[inline(never)] // 64 bits are long on a small target.
    #[must_use]
    pub const fn plus_millis(self, millis: u32) -> Self {
        self.plus_micros(millis as u64 * 1000)
    }
}
