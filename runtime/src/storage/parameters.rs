//! The objects 1010h, 1011h and 1020h.

use super::{capabilities, change, change::group_of, Change, Group};
use crate::{
    od::{self, Access, Device, Entry, ServiceSet},
    AbortCode, Address, Event,
};

/// 1010h: store parameters, an ARRAY of UNSIGNED32, its sub-indices the groups.
const STORE: u16 = 0x1010;
/// 1011h: restore default parameters, an ARRAY of UNSIGNED32, its sub-indices the groups.
const RESTORE: u16 = 0x1011;
/// 1020h: verify configuration, UNSIGNED32: date and time in sub-indices 1 and 2.
pub(super) const VERIFY_CONFIGURATION: u16 = 0x1020;

/// `save`, the first letter in the lowest byte.
const SAVE: u32 = u32::from_le_bytes(*b"save");
/// `load`
const LOAD: u32 = u32::from_le_bytes(*b"load");

/// Saves or restores, when that is what a client writes; says nothing of other objects, nor of those that the application
/// answers for.
///
/// # Errors
/// * [`AbortCode::NOT_STORED`] for a wrong signature, and without a storage
/// * [`AbortCode::HARDWARE_ERROR`] when the storage fails; then what was stored before is stored
pub(crate) fn before_write<D: Device>(device: &mut D, address: Address, number: u32) -> Result<(), AbortCode> {
    let (signature, what) = match address.index {
        STORE => (SAVE, Change::Save(Group(address.sub))),
        RESTORE => (LOAD, Change::Forget(Group(address.sub))),
        _ => return Ok(()),
    };
    let entry = device.table().find(address);
    if entry.is_some_and(|entry| entry.access.has(Access::WRITE_HANDLER)) {
        return Ok(());
    }
    if number != signature || capabilities(device) == 0 {
        return Err(AbortCode::NOT_STORED);
    }
    change(device, what).map_err(|_| AbortCode::HARDWARE_ERROR)?;
    device.event(match what {
        Change::Forget(group) => Event::Restored(group),
        _ => Event::Saved(Group(address.sub)),
    });
    Ok(())
}

/// What a write that was let through brings about: 1010h and 1011h read their capabilities again, and a changed configuration
/// is not the verified one.
pub(crate) fn after_write<D: Device>(device: &mut D, address: Address) {
    let is_command = matches!(address.index, STORE | RESTORE);
    if is_command {
        show_capabilities(device);
    }
    let verifies = D::SERVICES.has(ServiceSet::VERIFY_CONFIGURATION);
    if !verifies || matches!(address.index, VERIFY_CONFIGURATION | STORE) {
        return;
    }
    if is_command || group_of(device, address).is_some() {
        for sub in [1, 2] {
            let _ = od::set(device, Address::new(VERIFY_CONFIGURATION, sub), &[0; 4]);
        }
    }
}

/// Lets 1010h and 1011h say what the storage does (CiA 301, 7.5.2.13), where the application does not. A device that knows of no
/// storage keeps what its dictionary says.
pub(crate) fn show_capabilities<D: Device>(device: &mut D) {
    if device.storage().is_none() {
        return;
    }
    let capabilities = capabilities(device);
    for place in 0..device.table().entries.len() {
        let Some(entry) = device.table().entries.get(place).copied() else {
            return;
        };
        let capabilities = match entry.index {
            STORE => capabilities,
            RESTORE => u32::from(capabilities != 0),
            _ => continue,
        };
        if entry.sub != 0 && !is_handled(entry) {
            let _ = od::set(device, entry.address(), &capabilities.to_le_bytes());
        }
    }
}

/// Whether the application answers for it.
fn is_handled(entry: Entry) -> bool {
    entry.access.has(Access::READ_HANDLER) || entry.access.has(Access::WRITE_HANDLER)
}
