//! What a write to an object of the services brings about.

use super::pending::Pending;
use crate::{
    emcy, heartbeat,
    od::{Device, ServiceSet, Services, Value},
    pdo, sdo, storage, sync, time, AbortCode, Address,
};

/// Asks each service that has objects, and notes that they have changed. Not inlined: writes to other objects, the most,
/// are not to pay for it.
pub(super) struct Effects<'a, R> {
    pub(super) pending: &'a mut Pending,
    pub(super) pdos: &'a mut pdo::Set<R>,
}

impl<R: pdo::Room> Services for Effects<'_, R> {
    #[inline(never)]
    fn before_write<D: Device>(&mut self, device: &mut D, address: Address, value: Value<'_>) -> Result<(), AbortCode> {
        let number = value.to_u32();
        if D::SERVICES.has(ServiceSet::EMCY) {
            emcy::before_write(device, address, number)?;
        }
        if D::SERVICES.has(ServiceSet::SYNC) {
            sync::before_write(device, address, number)?;
        }
        if D::SERVICES.has(ServiceSet::HEARTBEAT_CONSUMER) {
            heartbeat::before_write(device, address, number)?;
        }
        if D::SERVICES.has(ServiceSet::TIME) {
            time::before_write(device, address, number)?;
        }
        pdo::before_write(device, address, number)?;
        if D::SERVICES.has(ServiceSet::SDO_SERVERS) {
            sdo::before_write(device, address, number)?;
        }
        if D::SERVICES.has(ServiceSet::STORAGE) {
            storage::before_write(device, address, number)?;
        }
        Ok(())
    }

    #[inline(never)]
    fn after_write<D: Device>(&mut self, device: &mut D, address: Address) {
        if D::SERVICES.has(ServiceSet::STORAGE.with(ServiceSet::VERIFY_CONFIGURATION)) {
            storage::after_write(device, address);
        }
        if address.index & 0xF000 != 0x1000 {
            return;
        }
        emcy::after_write(device, address);
        self.pdos.mark(address.index);
        self.pending.add(Pending::CONFIGURATION);
    }
}
