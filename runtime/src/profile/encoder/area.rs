//! Work areas (CiA 406, 8.3): whether the position is where it is to be, 6400h to 6402h.

/// Bit 0 of 6400h: the position is beyond a limit of the device, or of the work area.
pub const OUT_OF_RANGE: u8 = 0x01;
/// Bit 1 of 6400h: the position is above the high limit.
pub const OVERFLOW: u8 = 0x02;
/// Bit 2 of 6400h: the position is below the low limit.
pub const UNDERFLOW: u8 = 0x04;

/// The limits of a work area, and those of the device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Area {
    /// 6401h: the lowest position within.
    pub low: i32,
    /// 6402h: the highest position within.
    pub high: i32,
    /// 650Ah:02: the lowest position that the device is made for.
    pub minimum: i32,
    /// 650Ah:03: the highest position that the device is made for.
    pub maximum: i32,
}

/// The area state (6400h) of `position`: 0 within, 03h above and 05h below, as both encoders' manuals have it; 01h within
/// the area but beyond what the device is made for.
#[must_use]
pub fn area(area: &Area, position: i64) -> u8 {
    let mut state = 0;
    if position > i64::from(area.high) {
        state |= OVERFLOW | OUT_OF_RANGE;
    }
    if position < i64::from(area.low) {
        state |= UNDERFLOW | OUT_OF_RANGE;
    }
    if position < i64::from(area.minimum) || position > i64::from(area.maximum) {
        state |= OUT_OF_RANGE;
    }
    state
}
