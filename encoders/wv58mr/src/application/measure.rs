//! From what the sensor says to what the objects say.

use lexican_runtime::{
    AbortCode, Instant,
    profile::encoder::{self, Area, Faults, OUT_OF_RANGE, Parameters, Position, Reading, Sensor},
};

use super::Application;
use crate::{
    speed,
    variant::{RESOLUTION, Variant},
    wv58mr::Dictionary,
};

/// What is wrong, a bit for each emergency that the encoder raises itself (manual, table 14).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Causes(u8);

impl Causes {
    /// FF05h: position value error.
    pub(crate) const POSITION: Self = Self(0x01);
    /// FF12h: velocity error.
    pub(crate) const VELOCITY: Self = Self(0x02);
    /// FF13h: below the limit speed 2003h.
    pub(crate) const SPEED_LOW: Self = Self(0x04);
    /// FF14h: above the limit speed 2004h.
    pub(crate) const SPEED_HIGH: Self = Self(0x08);
    /// FF15h: beyond work area 1.
    pub(crate) const AREA_1: Self = Self(0x10);
    /// FF16h: beyond work area 2.
    pub(crate) const AREA_2: Self = Self(0x20);
    /// All, each with its emergency's code.
    pub(crate) const ALL: [(Self, u16); 6] = [
        (Self::POSITION, 0xFF05),
        (Self::VELOCITY, 0xFF12),
        (Self::SPEED_LOW, 0xFF13),
        (Self::SPEED_HIGH, 0xFF14),
        (Self::AREA_1, 0xFF15),
        (Self::AREA_2, 0xFF16),
    ];

    /// Whether any of `others` is among them.
    pub(crate) const fn has(self, others: Self) -> bool {
        self.0 & others.0 != 0
    }

    const fn with(self, others: Self) -> Self {
        Self(self.0 | others.0)
    }

    /// These, and `other` if it `stands`.
    const fn and(self, other: Self, stands: bool) -> Self {
        if stands { self.with(other) } else { self }
    }
}

/// Bit 0 of 6503h: the position is not valid.
const POSITION_ERROR: u16 = 0x0001;
/// Bits 12 and 13 of 6503h: beyond the work area.
const BEYOND_AREA: [u16; 2] = [0x1000, 0x2000];
/// Bit 0 of 6505h: the maximum speed is exceeded, or a limit speed is.
const SPEED_WARNING: u16 = 0x0001;

/// The position of a variant, with the scaling that the dictionary says.
pub(super) fn position(variant: Variant, od: &Dictionary) -> Result<Position, AbortCode> {
    let units_per_revolution = od.measuring_units_per_revolution;
    let parameters = Parameters {
        is_counterclockwise: od.operating_parameters & 0x0001 != 0,
        is_scaled: true,
        units_per_revolution,
        range: u64::from(variant.range(units_per_revolution)),
    };
    let shaft = variant.shaft().ok_or(AbortCode::INTERNAL_INCOMPATIBILITY)?;
    Position::new(shaft, parameters, 0)
}

impl<S: Sensor> Application<S> {
    /// 6000h or 6001h was written: the position, and all that says how far it goes.
    pub(super) fn scale(&mut self, od: &mut Dictionary) {
        // 6001h is within 1 to 65535, so that there is a position.
        if let Ok(position) = position(self.variant, od) {
            self.position = position;
        }
        let range = self.variant.range(od.measuring_units_per_revolution);
        od.total_measuring_range = range;
        od.operating_status = od.operating_parameters;
        let [_, minimum, maximum] = &mut od.module_identification;
        *minimum = 0;
        *maximum = range.saturating_sub(1).cast_signed();
        self.shift(od, od.application_offset);
    }

    /// 2002h: the measured value is 0 here, so that the position is the calibration value and the application offset.
    pub(super) fn calibrate(&mut self, od: &mut Dictionary) -> Result<(), AbortCode> {
        let reading = self.sensor.reading();
        self.position.preset(reading, u64::from(od.preset_value))?;
        self.zero = self.position.offset();
        self.shift(od, od.application_offset);
        Ok(())
    }

    /// 2001h: adds the application offset to what calibration adds.
    pub(super) fn shift(&mut self, od: &mut Dictionary, application_offset: i32) {
        self.position.set_offset(self.zero + i64::from(application_offset));
        od.offset_value = i32::try_from(self.position.offset()).unwrap_or(0);
    }

    /// Brings position, speed, work areas, alarms and warnings up to date.
    pub(super) fn measure(&mut self, od: &mut Dictionary, now: Instant) -> Causes {
        let reading = self.sensor.reading();
        let faults = self.sensor.faults();
        od.position_raw_value = self.raw(reading);
        let position = self.position.update(reading);
        od.position_value = u32::try_from(position).unwrap_or(u32::MAX);
        self.measure_speed(od, now);
        let causes = areas(od).with(speeds(od)).with(broken(faults));
        tell(od, causes);
        causes
    }

    /// 600Ch: steps of the shaft, neither scaled nor shifted, clockwise.
    fn raw(&self, reading: Reading) -> u32 {
        let turn = reading.turn % u64::from(self.variant.revolutions());
        u32::try_from(turn).unwrap_or(0) * RESOLUTION + reading.angle % RESOLUTION
    }

    fn measure_speed(&mut self, od: &mut Dictionary, now: Instant) {
        let parameters = speed::Parameters {
            integration_time: od.speed_parameters_speed_integration_time,
            multiplier: od.speed_parameters_speed_multiplier,
            divisor: od.speed_parameters_speed_divisor,
        };
        let steps = self.variant.range(RESOLUTION);
        if let Some(speed) = self.speed.update(now, od.position_raw_value, steps, parameters) {
            od.speed_value = [speed];
        }
    }
}

/// 6400h: where the position is in each work area; a work area whose limits are both 0, as delivered, is not watched.
fn areas(od: &mut Dictionary) -> Causes {
    let [_, minimum, maximum] = od.module_identification;
    let limits = od.work_area_low_limit.into_iter().zip(od.work_area_high_limit);
    let mut causes = Causes::default();
    for ((state, (low, high)), cause) in od
        .area_state_register
        .iter_mut()
        .zip(limits)
        .zip([Causes::AREA_1, Causes::AREA_2])
    {
        let area = Area {
            low,
            high,
            minimum,
            maximum,
        };
        let is_watched = low != 0 || high != 0;
        *state = if is_watched {
            encoder::area(&area, i64::from(od.position_value))
        } else {
            0
        };
        causes = causes.and(cause, *state & OUT_OF_RANGE != 0);
    }
    causes
}

/// Whether the speed is beyond 2003h or 2004h; limits that are both 0, as delivered, are not watched.
fn speeds(od: &Dictionary) -> Causes {
    let (low, high) = (od.limit_speed_low, od.limit_speed_high);
    let [speed] = od.speed_value;
    let is_watched = low != 0 || high != 0;
    Causes::default()
        .and(Causes::SPEED_LOW, is_watched && speed < low)
        .and(Causes::SPEED_HIGH, is_watched && speed > high)
}

/// What the sensor itself finds wrong.
fn broken(faults: Faults) -> Causes {
    let position = Faults::POSITION.with(Faults::SINGLE_TURN).with(Faults::REVOLUTIONS);
    Causes::default()
        .and(Causes::POSITION, faults.has(position))
        .and(Causes::VELOCITY, faults.has(Faults::SPEED))
}

/// Shows in 6503h and 6505h what is wrong.
fn tell(od: &mut Dictionary, causes: Causes) {
    let bit = |bit: u16, cause: Causes| if causes.has(cause) { bit } else { 0 };
    let [area_1, area_2] = BEYOND_AREA;
    od.alarms = bit(POSITION_ERROR, Causes::POSITION) | bit(area_1, Causes::AREA_1) | bit(area_2, Causes::AREA_2);
    let speed = Causes::VELOCITY.with(Causes::SPEED_LOW).with(Causes::SPEED_HIGH);
    od.warnings = bit(SPEED_WARNING, speed);
}
