//! TIME (CiA 301, 7.2.6 and object 1012h): the consumer.
//!
//! ```text
//! 100#00.00.E0.02.F2.3C     12:46:40 and 0 ms on 10 November 2026; six bytes, a TIME_OF_DAY
//! ```

use crate::{
    od::{self, Device, TimeOfDay},
    wire::{CanId, CobId, Frame},
    AbortCode, Address,
};

/// 1012h: COB-ID TIME, UNSIGNED32; bit 31 set for a consumer, bit 30 for a producer.
pub const COB_ID_TIME: Address = Address::new(0x1012, 0x00);

/// The time in `frame`, if it is a TIME message for `device`.
pub fn receive<D: Device>(device: &D, id: CanId, frame: &Frame) -> Option<TimeOfDay> {
    let cob_id = cob_id(device)?;
    if !consumes(cob_id) || cob_id.can_id() != Some(id) {
        return None;
    }
    frame.data().try_into().ok().map(TimeOfDay::from_bytes)
}

/// Refuses what a client may not write to 1012h; says nothing of other objects.
///
/// # Errors
/// [`AbortCode::INVALID_VALUE`] for a producer, which this node is not; for other bits 0 to 29 while bit 31 is and stays set;
/// for an identifier that [`CobId::check`] refuses.
pub fn before_write<D: Device>(device: &D, address: Address, value: u32) -> Result<(), AbortCode> {
    if address != COB_ID_TIME {
        return Ok(());
    }
    let (old, new) = (cob_id(device).unwrap_or_default(), CobId(value));
    if new.has_bit_30() || consumes(old) && consumes(new) && !new.has_identifier_of(old) {
        return Err(AbortCode::INVALID_VALUE);
    }
    new.check()
}

/// Bit 31 means here what it does nowhere else: the message is consumed.
const fn consumes(cob_id: CobId) -> bool {
    !cob_id.is_valid()
}

fn cob_id<D: Device>(device: &D) -> Option<CobId> {
    od::configured(device, COB_ID_TIME).map(CobId)
}
