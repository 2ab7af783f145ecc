//! What a communication service has to say when one of its objects is written.

use super::{Device, Value};
use crate::{AbortCode, Address};

/// The services behind the objects 1000h to 1FFFh. They are asked about writes to those objects, and told of them; of a device
/// that has 1020h (verify configuration) they are told of writes to all others too.
///
/// `()` has nothing to say.
pub trait Services {
    /// `value` is about to be stored at `address`; access, length and limits are checked.
    ///
    /// # Errors
    /// The abort code that the client is to be answered with; then nothing is stored.
    fn before_write<D: Device>(&mut self, device: &mut D, address: Address, value: Value<'_>) -> Result<(), AbortCode> {
        let _ = (device, address, value);
        Ok(())
    }

    /// The value at `address` was stored.
    fn after_write<D: Device>(&mut self, device: &mut D, address: Address) {
        let _ = (device, address);
    }
}

impl Services for () {}
