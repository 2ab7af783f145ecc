//! What a client may write to the parameters of PDOs.

use super::{cob_id, mapping, mpdo, parameter, sub, Direction, Mapped};
use crate::{
    od::{self, Device, ServiceSet},
    wire::CobId,
    AbortCode, Address,
};

/// Refuses what a client may not write to the objects of PDOs, in any NMT state; says nothing of others.
///
/// # Errors
/// Of communication parameters (CiA 301, 7.5.2.35 and 7.5.2.37), [`AbortCode::INVALID_VALUE`]
/// * for a COB-ID that is valid before and after, and changes bits 0 to 29; or an identifier that [`CobId::check`] refuses
/// * for a reserved transmission type: 241 to 251, of an RPDO 252 and 253 too
/// * for another inhibit time or SYNC start value of a TPDO that is valid, and a SYNC start value above 240
///
/// Of mapping parameters (7.5.2.36 and 7.5.2.38)
/// * [`AbortCode::UNSUPPORTED_ACCESS`] while the PDO is valid; of an entry also while sub-index 0 is not 0
/// * [`AbortCode::NO_SUCH_OBJECT`]
/// * [`AbortCode::NOT_MAPPABLE`] in this direction, or with this length
/// * [`AbortCode::PDO_TOO_LONG`] for a sub-index 0 with which the PDO has more than 64 bits, or more entries than there are
pub fn before_write<D: Device>(device: &D, address: Address, value: u32) -> Result<(), AbortCode> {
    use Direction::{Receive, Transmit};
    match address.index {
        0x1400..=0x15FF => before_communication(device, Receive, address, value),
        0x1600..=0x17FF => before_mapping(device, Receive, address, value),
        0x1800..=0x19FF => before_communication(device, Transmit, address, value),
        0x1A00..=0x1BFF => before_mapping(device, Transmit, address, value),
        _ => Ok(()),
    }
}

/// The number of the PDO that the object at `index` is about.
pub(super) const fn number(index: u16) -> u16 {
    (index & 0x01FF) + 1
}

fn before_communication<D: Device>(
    device: &D,
    direction: Direction,
    Address { index, sub }: Address,
    value: u32,
) -> Result<(), AbortCode> {
    let old = cob_id(device, direction, number(index));
    // What sends in one direction only has no meaning in the other.
    let is_fixed = direction == Direction::Transmit && old.is_valid();
    match sub {
        sub::COB_ID => CobId(value).check_change(old),
        sub::TRANSMISSION_TYPE => check_transmission_type(direction, value),
        sub::SYNC_START_VALUE if value > 240 => Err(AbortCode::INVALID_VALUE),
        sub::INHIBIT_TIME | sub::SYNC_START_VALUE
            if is_fixed && value != od::parameter(device, Address::new(index, sub)) =>
        {
            Err(AbortCode::INVALID_VALUE)
        }
        _ => Ok(()),
    }
}

fn check_transmission_type(direction: Direction, value: u32) -> Result<(), AbortCode> {
    match (direction, value) {
        (_, 0..=240 | 254..=255) | (Direction::Transmit, 252..=253) => Ok(()),
        _ => Err(AbortCode::INVALID_VALUE),
    }
}

fn before_mapping<D: Device>(
    device: &D,
    direction: Direction,
    Address { index, sub }: Address,
    value: u32,
) -> Result<(), AbortCode> {
    let is_mapped = sub != 0 && parameter(device, index, 0) != 0;
    if is_mapped || cob_id(device, direction, number(index)).is_valid() {
        return Err(AbortCode::UNSUPPORTED_ACCESS);
    }
    match (sub, value) {
        (0, count) if D::SERVICES.has(ServiceSet::MPDO) && mpdo::is_multiplexed(count) => Ok(()),
        (0, count) => mapping::resolve(device, direction, index, count, &mut []).map(|_| ()),
        // No object: an entry that is not used.
        (_, 0) => Ok(()),
        (_, entry) => Mapped::resolve(device, direction, entry).map(|_| ()),
    }
}
