//! What a client may write (manual, 5.7.2), beyond the limits that the EDS has.

use lexican_runtime::{AbortCode, NmtState, wire::CobId};

use crate::{variant::Variant, wv58mr::Dictionary};

/// COB-IDs are changed in PRE-OPERATIONAL only (5.1).
pub(super) fn state(state: NmtState) -> Result<(), AbortCode> {
    allow(state == NmtState::PreOperational, AbortCode::DEVICE_STATE)
}

/// 1005h: the encoder generates no SYNC (5.7.2.5).
pub(super) fn sync(value: u32) -> Result<(), AbortCode> {
    allow(!CobId(value).has_bit_30(), AbortCode::INVALID_VALUE)
}

/// 1017h: off, or 10 ms and more (5.7.2.14).
pub(super) fn heartbeat(value: u16) -> Result<(), AbortCode> {
    allow(value == 0 || value >= 10, AbortCode::INVALID_VALUE)
}

/// 1800h:02: by the timer, or on RTR only (5.7.2.17).
pub(super) fn asynchronous(value: u8) -> Result<(), AbortCode> {
    allow(matches!(value, 253..=255), AbortCode::INVALID_VALUE)
}

/// 1801h:02: with every nth SYNC too (5.7.2.18).
pub(super) fn synchronous(value: u8) -> Result<(), AbortCode> {
    allow(matches!(value, 1..=240 | 253..=255), AbortCode::INVALID_VALUE)
}

/// 2001h: within the physical range (5.7.2.21).
pub(super) fn application_offset(variant: Variant, value: i32) -> Result<(), AbortCode> {
    let refusal = if value < 0 {
        AbortCode::VALUE_TOO_LOW
    } else {
        AbortCode::VALUE_TOO_HIGH
    };
    allow(variant.allows_offset(value), refusal)
}

/// 6000h: the direction is chosen by bit 0; scaling, bit 2, is always on; no other bit is used (5.7.2.27).
pub(super) fn operating_parameters(value: u16) -> Result<(), AbortCode> {
    allow(value & !0x0001 == 0x0004, AbortCode::INVALID_VALUE)
}

/// 6003h: a position (5.7.2.30).
pub(super) fn position(od: &Dictionary, value: u32) -> Result<(), AbortCode> {
    allow(value < od.total_measuring_range, AbortCode::VALUE_TOO_HIGH)
}

/// 6401h, 6402h: a position (5.7.2.37, 5.7.2.38).
pub(super) fn limit(od: &Dictionary, value: i32) -> Result<(), AbortCode> {
    position(od, value.unsigned_abs())
}

/// One value is allowed only.
pub(super) fn only<T: Copy + PartialEq>(value: T, allowed: T) -> Result<(), AbortCode> {
    allow(value == allowed, AbortCode::INVALID_VALUE)
}

fn allow(is_right: bool, refusal: AbortCode) -> Result<(), AbortCode> {
    if is_right { Ok(()) } else { Err(refusal) }
}
