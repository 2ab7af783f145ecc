//! What an encoder measures with: the source of all that the profile computes.

use super::{Reading, Shaft};

/// A position sensor, as an encoder's application reads it: hardware in the firmware, a motion script on a host.
///
/// The methods do not block: an encoder asks for the position a thousand times a second and more, and expects what was
/// measured last.
pub trait Sensor {
    /// What it can tell apart (6501h, 6502h, 6510h). It does not change while the encoder is running.
    fn shaft(&self) -> Shaft;

    /// Where the shaft is. When [`Faults::POSITION`] is among the faults, the last reading that was good.
    fn reading(&mut self) -> Reading;

    /// The temperature within the device, in °C; `None` when it cannot be read, and of a device without such a sensor.
    fn temperature(&mut self) -> Option<i16> {
        None
    }

    /// What is wrong with the sensor at the moment. Nothing unless overridden.
    fn faults(&mut self) -> Faults {
        Faults::NONE
    }
}

/// What is wrong with a sensor, a set of bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Faults(u8);

impl Faults {
    /// All is well.
    pub const NONE: Self = Self(0x00);
    /// The position is not valid: bit 0 of the alarms (6503h).
    pub const POSITION: Self = Self(0x01);
    /// The scanning of the single turn is not right.
    pub const SINGLE_TURN: Self = Self(0x02);
    /// The counting of revolutions is not right.
    pub const REVOLUTIONS: Self = Self(0x04);
    /// The light source, or what else drives the sensor, is at its limit: bit 1 of the warnings (6505h).
    pub const LIGHT: Self = Self(0x08);
    /// The battery that keeps the revolutions is low: bit 4 of the warnings (6505h).
    pub const BATTERY: Self = Self(0x10);
    /// The temperature cannot be read, though there is a sensor for it.
    pub const TEMPERATURE: Self = Self(0x20);
    /// The shaft turns faster than the sensor can follow: the speed is not valid.
    pub const SPEED: Self = Self(0x40);

    /// These and `other`.
    #[must_use]
    pub const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether any of `other` is among them.
    #[must_use]
    pub const fn has(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }
}

impl<S: Sensor + ?Sized> Sensor for &mut S {
    fn shaft(&self) -> Shaft {
        (**self).shaft()
    }

    fn reading(&mut self) -> Reading {
        (**self).reading()
    }

    fn temperature(&mut self) -> Option<i16> {
        (**self).temperature()
    }

    fn faults(&mut self) -> Faults {
        (**self).faults()
    }
}
