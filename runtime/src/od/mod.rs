//! The object dictionary: what is in flash ([`Table`]), what is in RAM ([`Device::Values`]), and how both are reached.
//!
//! A generated dictionary is one plain struct of typed fields. The services never see its type: they see its bytes
//! (by [`bytemuck`], without `unsafe` here or in generated code) and a table of [`Entry`]s that says which bytes are
//! which object. So generated code holds declarations only, and a read is: find the entry, copy the bytes.
//!
//! Values stand in the struct in the target's own byte order; on the bus they are little-endian.

mod data_type;
mod entry;
mod table;
mod values;

pub use data_type::DataType;
pub use entry::{Access, Entry, Extra};
pub use table::{lookup_key, place, Table};
pub use values::{Boolean, OctetString, TimeOfDay, VisibleString};

use crate::{AbortCode, Address, NodeId};

/// A device: the dictionary that was generated for it, and the application behind it.
///
/// Implemented by generated code; an application implements the generated `Handlers` trait instead.
pub trait Device {
    /// The struct of values, `#[repr(C)]`, without padding.
    type Values: bytemuck::Pod;
    /// Room for the longest value that a client may write, `[u8; N]`.
    type Buffer: AsRef<[u8]> + AsMut<[u8]>;

    /// The dictionary's entries, in flash.
    const TABLE: Table;
    /// An empty buffer.
    const BUFFER: Self::Buffer;

    /// The values.
    fn values(&self) -> &Self::Values;

    /// The values, to write.
    fn values_mut(&mut self) -> &mut Self::Values;

    /// Sets every value that the EDS gives as a formula of `$NODEID`.
    fn set_node_id(&mut self, node_id: NodeId);

    /// Asks the application to bring the value at `address` up to date in [`Device::values_mut`] before it is read.
    ///
    /// Called only for entries with [`Access::READ_HANDLER`].
    ///
    /// # Errors
    /// The abort code that the client is to be answered with.
    fn before_read(&mut self, address: Address) -> Result<(), AbortCode>;

    /// Offers the application the value that is about to be stored at `address`: `value` is as it came from the bus,
    /// little-endian, its length and limits checked.
    ///
    /// Called only for entries with [`Access::WRITE_HANDLER`].
    ///
    /// # Errors
    /// The abort code that the client is to be answered with; then nothing is stored.
    fn before_write(&mut self, address: Address, value: &[u8]) -> Result<(), AbortCode>;
}
