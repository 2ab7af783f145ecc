//! What a write to an object of the services brings about.

use super::pending::Pending;
use crate::{
    emcy,
    od::{Device, Services, Value},
    AbortCode, Address,
};

/// Asks each service that has objects, and notes that they have changed.
pub(super) struct Effects<'a> {
    pub(super) pending: &'a mut Pending,
}

impl Services for Effects<'_> {
    fn before_write<D: Device>(&mut self, device: &D, address: Address, value: Value<'_>) -> Result<(), AbortCode> {
        emcy::before_write(device, address, value)
    }

    fn after_write<D: Device>(&mut self, device: &mut D, address: Address) {
        emcy::after_write(device, address);
        self.pending.add(Pending::CONFIGURATION);
    }
}
