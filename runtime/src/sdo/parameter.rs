//! What a client may write to the parameters of the servers beyond the first.

use crate::{
    od::{self, Device},
    wire::CobId,
    AbortCode, Address,
};

/// 1201h to 127Fh:01, COB-ID of the requests.
pub(super) const CLIENT_TO_SERVER: u8 = 1;
/// 1201h to 127Fh:02, COB-ID of the responses.
pub(super) const SERVER_TO_CLIENT: u8 = 2;

/// Refuses what a client may not write to 1201h to 127Fh; says nothing of other objects. Bit 30 (the connection is dynamic) and
/// sub-index 3 (the client's node-ID) are stored, and mean nothing here.
///
/// # Errors
/// [`AbortCode::INVALID_VALUE`] for a COB-ID that is valid before and after, and changes bits 0 to 29; or an identifier that
/// [`CobId::check`] refuses (CiA 301, 7.5.2.33).
pub fn before_write<D: Device>(device: &D, address: Address, value: u32) -> Result<(), AbortCode> {
    match (address.index, address.sub) {
        (0x1201..=0x127F, CLIENT_TO_SERVER | SERVER_TO_CLIENT) => CobId(value).check_change(cob_id(device, address)),
        _ => Ok(()),
    }
}

/// The COB-ID at `address`; one that is not valid where there is none.
pub(super) fn cob_id<D: Device>(device: &D, address: Address) -> CobId {
    CobId(od::configured(device, address).unwrap_or(u32::MAX))
}
