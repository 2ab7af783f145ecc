//! The object dictionary: what is in flash ([`Table`]), what is in RAM ([`Device::values`]), and how both are reached.
//!
//! A generated dictionary is one plain struct of typed fields. The services never see its type: they see its bytes
//! (by [`bytemuck`], without `unsafe` here or in generated code) and a table of [`Entry`]s that says which bytes are
//! which object. So generated code holds declarations only, and a read is: find the entry, copy the bytes.
//!
//! Values stand in the struct in the target's own byte order; on the bus and in [`Table::constants`] they are
//! little-endian. Integers that Rust has no type for are widened, with their sign: 24 bits stand in 4 bytes, 40, 48 and
//! 56 bits in 8.

mod data_type;
mod device;
mod entry;
mod image;
mod limits;
mod number_set;
mod part;
mod read;
mod reset;
mod row;
mod service_set;
mod services;
mod table;
mod value;
mod values;
mod write;

pub use data_type::DataType;
pub use device::{Device, Reset};
pub use entry::{Access, Entry, Extra};
pub use image::{resized, written};
pub use number_set::NumberSet;
pub use part::{copy_part, Part};
pub use read::{configured, load, number, parameter, read, readable};
pub use reset::{resolve_node_id, restore};
pub use row::Row;
pub use service_set::ServiceSet;
pub use services::Services;
pub use table::{bucket_of, lookup_key, place, place_of, Table};
pub use value::Value;
pub use values::{set_element, Boolean, OctetString, TimeOfDay, VisibleString};
pub use write::{capacity, check_length, set, store, writable, write};
pub(crate) use write::{set_within_limits, store_number};
