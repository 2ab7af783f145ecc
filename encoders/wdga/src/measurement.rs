//! From the sensor's reading to the objects of CiA 406.

use lexican_runtime::{
    AbortCode, Instant,
    profile::encoder::{Cams, Filter, Parameters, Position, Reading, Shaft, way},
};

use crate::{
    motion::Motion,
    places::{show_area, show_cams},
    wdga::Dictionary,
};

/// 6000h, bit 0: positions increase counterclockwise.
const COUNTERCLOCKWISE: u16 = 0x0001;
/// 6000h, bit 2: 6001h and 6002h count.
const SCALING: u16 = 0x0004;
/// 6000h: the bits that mean something (table 8.61).
pub(crate) const OPERATING_PARAMETERS: u16 = COUNTERCLOCKWISE | SCALING;
/// 6002h is UNSIGNED32, so 0 stands for all of its steps (chapter 8.6).
const FULL_RANGE: u64 = 1 << 32;

/// What is computed of the shaft: the position with 32 bits (6004h), and with 64 (6008h).
///
/// Both count the same shaft. The circle of the one is as long as 6002h says, that of the other has all revolutions (6510h).
#[derive(Clone, Debug)]
pub(crate) struct Measurement {
    shaft: Shaft,
    reading: Reading,
    position: Position,
    precise: Position,
    filters: [Filter; 2],
    /// Where [`Measurement::precise`] was, unfiltered: ways on the long circle have one meaning only.
    place: Option<u64>,
    motion: Motion,
    cams: Cams,
}

impl Measurement {
    /// Of a shaft, by the parameters and the offset of `od`.
    pub(crate) fn new(shaft: Shaft, od: &Dictionary) -> Self {
        let [position, precise] = circles(shaft, od);
        let mut measurement = Self {
            shaft,
            reading: Reading::default(),
            position,
            precise,
            filters: [Filter::new(); 2],
            place: None,
            motion: Motion::default(),
            cams: Cams::new(),
        };
        measurement.position.set_offset(od.offset_value.into());
        measurement.precise.set_offset(od.offset_value.into());
        measurement
    }

    /// The parameters (6000h to 6002h) are others: positions are counted anew, without a preset.
    pub(crate) fn configure(&mut self, od: &mut Dictionary) {
        od.offset_value = 0;
        *self = Self::new(self.shaft, od);
    }

    /// Takes a reading; says whether the position has changed.
    pub(crate) fn update(&mut self, od: &mut Dictionary, now: Instant, reading: Reading) -> bool {
        self.reading = reading;
        let before = od.position_value;
        let last = self.place;
        let place = self.show(od);
        let way = last.map_or(0, |last| way(last, place, self.precise.range()));
        self.motion.update(od, now, way);
        od.position_value != before
    }

    /// Whether the shaft is faster than the frequency limit (2107h).
    pub(crate) const fn is_too_fast(&self) -> bool {
        self.motion.is_too_fast()
    }

    /// 6003h: moves both circles by the same way.
    pub(crate) fn preset(&mut self, od: &mut Dictionary, value: u32) -> Result<(), AbortCode> {
        self.position.preset(self.reading, value.into())?;
        self.precise.set_offset(self.position.offset());
        self.show_offset(od);
        Ok(())
    }

    /// 6009h: the position with 32 bits is what is left of it.
    pub(crate) fn preset_precise(&mut self, od: &mut Dictionary, value: u64) -> Result<(), AbortCode> {
        self.precise.preset(self.reading, value)?;
        self.position.preset(self.reading, value % self.position.range())?;
        self.show_offset(od);
        Ok(())
    }

    fn show_offset(&mut self, od: &mut Dictionary) {
        // Half of the longest range is 2³¹, which is the same way as −2³¹.
        od.offset_value = i32::try_from(self.position.offset()).unwrap_or(i32::MIN);
        self.filters = [Filter::new(); 2];
        self.show(od);
    }

    /// Shows the reading; gives the unfiltered place on the long circle.
    fn show(&mut self, od: &mut Dictionary) -> u64 {
        let strength = od.integration_value_position_filter.saturating_sub(1);
        let [filter, precise_filter] = &mut self.filters;
        let range = self.position.range();
        let position = filter.update(self.position.update(self.reading), range, strength);
        let place = self.precise.update(self.reading);
        self.place = Some(place);
        od.operating_status = od.operating_parameters;
        // The range is 2³² at most.
        od.position_value = u32::try_from(position).unwrap_or(u32::MAX);
        od.high_precision_position_value = precise_filter.update(place, self.precise.range(), strength);
        show_cams(&mut self.cams, od, position, range);
        show_area(od, od.position_value);
        place
    }
}

/// 6002h that an encoder with this shaft is delivered with: all its steps, up to 2³², which is 0.
pub(crate) fn default_range(shaft: Shaft) -> u32 {
    u32::try_from(shaft.steps()).unwrap_or(0)
}

/// Refuses 6001h and 6002h that make no position (chapter 8.6).
pub(crate) fn check(shaft: Shaft, units: u32, range: u32) -> Result<(), AbortCode> {
    if range == 0 && shaft.steps() < FULL_RANGE {
        return Err(AbortCode::VALUE_TOO_LOW);
    }
    parameters(0, units, full(range)).check()
}

/// The two circles, not read yet. Parameters that make no position, which only a damaged memory has, do not scale.
fn circles(shaft: Shaft, od: &Dictionary) -> [Position; 2] {
    let code = od.operating_parameters;
    let unscaled = (shaft.resolution(), shaft.steps().min(FULL_RANGE));
    let scaled = (od.measuring_units_per_revolution, full(od.total_measuring_range));
    let is_scaled = code & SCALING != 0 && check(shaft, scaled.0, od.total_measuring_range).is_ok();
    let (units, range) = if is_scaled { scaled } else { unscaled };
    let whole = shaft.revolutions().saturating_mul(units.into());
    [range, whole].map(|range| {
        let wanted = Position::new(shaft, parameters(code, units, range), 0);
        wanted.unwrap_or_else(|_| Position::unscaled(shaft))
    })
}

const fn parameters(code: u16, units: u32, range: u64) -> Parameters {
    Parameters {
        is_counterclockwise: code & COUNTERCLOCKWISE != 0,
        is_scaled: true,
        units_per_revolution: units,
        range,
    }
}

fn full(range: u32) -> u64 {
    if range == 0 { FULL_RANGE } else { range.into() }
}
