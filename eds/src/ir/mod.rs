//! What the device is: resolved, sorted, total. The one thing that every back end reads.
//!
//! No text of the file is left to interpret here: numbers are numbers, compact forms are expanded, CiA 306's defaults
//! are applied, the values of a DCF stand in place of the EDS's defaults, modules are composed. A `$NODEID` formula
//! stays a formula ([`Value::NodeIdPlus`]), because the node-ID may change while the device runs.

mod address;
mod data_type;
mod device;
mod dictionary;
pub mod lower;
mod object;
mod order;
mod pdo;
mod value;

pub use address::{Address, NodeId};
pub use data_type::DataType;
pub use device::{BaudRates, Commissioning, DeviceInfo, FileInfo};
pub use dictionary::Dictionary;
pub use lower::Problem;
pub use object::{AccessType, Entry, EntrySpans, Object, ObjectCode, ObjectList};
pub use pdo::{Direction, MappedObject, Pdo};
pub use value::Value;
