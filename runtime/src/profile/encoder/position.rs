//! The position value (CiA 406, 8.1.1 to 8.1.5): 6004h, and 6008h with 64 bits.
//!
//! A position counts on for ever: on a circle of as many steps as the total measuring range has. Where the sensor's own
//! revolutions end, the circle goes on: what is left of the range there is remembered, so that no position is left out or
//! passed twice. An encoder keeps that in its memory, with the preset's offset ([`Position::memory`]).

use super::{add, distance, multiply, way, wrapped};
use crate::AbortCode;

/// What the sensor can tell apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shaft {
    resolution: u32,
    revolutions: u64,
}

impl Shaft {
    /// A sensor with so many steps a revolution (6501h), and so many revolutions (6502h, 6510h; 1 of a single-turn one).
    /// `None` when one of them is 0, or there are more than 2⁶⁴ − 1 steps.
    #[must_use]
    pub const fn new(resolution: u32, revolutions: u64) -> Option<Self> {
        match revolutions.checked_mul(resolution as u64) {
            None | Some(0) => None,
            Some(_) => Some(Self {
                resolution,
                revolutions,
            }),
        }
    }

    /// One step, one revolution: the least that a shaft may have.
    pub const ONE: Self = Self {
        resolution: 1,
        revolutions: 1,
    };

    /// Steps a revolution, 1 or more.
    #[must_use]
    pub const fn resolution(self) -> u32 {
        self.resolution
    }

    /// Revolutions, 1 or more.
    #[must_use]
    pub const fn revolutions(self) -> u64 {
        self.revolutions
    }

    /// All steps.
    #[must_use]
    pub const fn steps(self) -> u64 {
        self.revolutions * self.resolution as u64
    }

    /// The same place, counted in the other direction; step 0 stays.
    const fn mirrored(self, reading: Reading) -> Reading {
        let Reading { turn, angle } = reading;
        if angle != 0 {
            return Reading {
                turn: self.revolutions - 1 - turn,
                angle: self.resolution - angle,
            };
        }
        let turn = if turn == 0 { 0 } else { self.revolutions - turn };
        Reading { turn, angle }
    }
}

/// Where the shaft is, as the sensor says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Reading {
    /// Whole revolutions, below the sensor's number of them; a higher one counts as what is left of it.
    pub turn: u64,
    /// Steps of the revolution, below the sensor's resolution; a higher one counts as what is left of it.
    pub angle: u32,
}

/// The operating parameters, and those of scaling.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parameters {
    /// 6000h, bit 0: positions increase counterclockwise.
    pub is_counterclockwise: bool,
    /// 6000h, bit 2: the two below count. Otherwise a position is what the sensor says.
    pub is_scaled: bool,
    /// 6001h: measuring units per revolution, 1 or more.
    pub units_per_revolution: u32,
    /// 6002h: total measuring range in measuring units, no fewer than a revolution has.
    pub range: u64,
}

impl Parameters {
    /// Refuses what makes no position: for a client that writes 6001h or 6002h.
    ///
    /// # Errors
    /// [`AbortCode::VALUE_TOO_LOW`] for no units at all, and for a range below the units of a revolution.
    pub const fn check(&self) -> Result<(), AbortCode> {
        if self.units_per_revolution == 0 || self.range < self.units_per_revolution as u64 {
            return Err(AbortCode::VALUE_TOO_LOW);
        }
        Ok(())
    }
}

/// The position, and what it remembers.
#[derive(Clone, Copy, Debug)]
pub struct Position {
    shaft: Shaft,
    is_counterclockwise: bool,
    units: u32,
    range: u64,
    /// Steps of the range that are over when the sensor's revolutions are.
    rest: u64,
    /// Where on the range the sensor's first revolution begins.
    base: u64,
    /// By the preset.
    offset: u64,
    /// Of the last reading, from the beginning of the sensor's revolutions on.
    step: Option<u64>,
}

impl Position {
    /// The position of `shaft`, before its first reading; `memory` is what [`Position::memory`] gave before power-off, 0 when
    /// there is nothing, or when the parameters are others now.
    ///
    /// # Errors
    /// As [`Parameters::check`].
    pub const fn new(shaft: Shaft, parameters: Parameters, memory: u64) -> Result<Self, AbortCode> {
        let (units, range) = if parameters.is_scaled {
            if let Err(refused) = parameters.check() {
                return Err(refused);
            }
            (parameters.units_per_revolution, parameters.range)
        } else {
            (shaft.resolution, shaft.steps())
        };
        Ok(Self::counting(
            shaft,
            parameters.is_counterclockwise,
            units,
            range,
            memory % range,
        ))
    }

    /// What the sensor of `shaft` says, before its first reading.
    #[must_use]
    pub const fn unscaled(shaft: Shaft) -> Self {
        Self::counting(shaft, false, shaft.resolution, shaft.steps(), 0)
    }

    const fn counting(shaft: Shaft, is_counterclockwise: bool, units: u32, range: u64, base: u64) -> Self {
        Self {
            shaft,
            is_counterclockwise,
            units,
            range,
            rest: multiply(shaft.revolutions, units as u64, range),
            base,
            offset: 0,
            step: None,
        }
    }

    /// How many steps there are: positions are below it.
    #[must_use]
    pub const fn range(&self) -> u64 {
        self.range
    }

    /// Takes a reading; gives the position. Between two readings the shaft is to turn less than half of the sensor's
    /// revolutions, of a single-turn sensor less than half a revolution.
    pub fn update(&mut self, reading: Reading) -> u64 {
        let Reading { turn, angle } = self.counted(reading);
        self.pass_the_end(turn, angle);
        let scaled = self.scaled(turn, angle);
        add(add(scaled, self.base, self.range), self.offset, self.range)
    }

    /// Gives the position of `reading` the value `preset` (6003h, 6009h).
    ///
    /// # Errors
    /// [`AbortCode::VALUE_TOO_HIGH`] for a preset that is no position; then nothing has changed.
    pub fn preset(&mut self, reading: Reading, preset: u64) -> Result<(), AbortCode> {
        if preset >= self.range {
            return Err(AbortCode::VALUE_TOO_HIGH);
        }
        self.offset = 0;
        let position = self.update(reading);
        self.offset = distance(position, preset, self.range);
        Ok(())
    }

    /// 6509h: what the preset adds to the position, as the shorter way: up to half of the range, negative or positive.
    #[must_use]
    pub fn offset(&self) -> i64 {
        way(0, self.offset, self.range)
    }

    /// Takes the offset that [`Position::offset`] gave before power-off. One that is beyond the range counts as what is
    /// left of it.
    pub fn set_offset(&mut self, offset: i64) {
        let size = offset.unsigned_abs() % self.range;
        self.offset = if offset < 0 {
            distance(size, 0, self.range)
        } else {
            size
        };
    }

    /// What is to outlive power-off, so that the position does not jump at the end of the sensor's revolutions. It changes
    /// only there.
    #[must_use]
    pub const fn memory(&self) -> u64 {
        self.base
    }

    /// The reading in the direction that counts.
    fn counted(&self, reading: Reading) -> Reading {
        let reading = Reading {
            turn: wrapped(reading.turn, self.shaft.revolutions),
            angle: reading.angle % self.shaft.resolution,
        };
        if self.is_counterclockwise {
            self.shaft.mirrored(reading)
        } else {
            reading
        }
    }

    /// Moves the base when the shaft has passed the end of the sensor's revolutions, by the shorter way.
    fn pass_the_end(&mut self, turn: u64, angle: u32) {
        let steps = self.shaft.steps();
        let step = turn * u64::from(self.shaft.resolution) + u64::from(angle);
        let Some(last) = self.step.replace(step) else { return };
        let is_forward = distance(last, step, steps) <= steps / 2;
        if is_forward && step < last {
            self.base = add(self.base, self.rest, self.range);
        } else if !is_forward && step > last {
            self.base = distance(self.rest, self.base, self.range);
        }
    }

    /// Measuring units from the beginning of the sensor's revolutions on.
    fn scaled(&self, turn: u64, angle: u32) -> u64 {
        let units = u64::from(self.units);
        let whole = multiply(turn, units, self.range);
        add(
            whole,
            u64::from(angle) * units / u64::from(self.shaft.resolution),
            self.range,
        )
    }
}
