//! Bytes ↔ meaning: one message family a file, no state.
//!
//! Each message is an enum or struct with `parse` (bytes → meaning) and `emit` (meaning → bytes), for both directions, so
//! that a master speaks with the same code. The contract of the whole layer:
//!
//! * `parse` takes any bytes and never panics. It ignores reserved bits, as CiA 301 asks of a receiver.
//! * `emit` sets reserved bits and bytes to 0, as CiA 301 asks of a sender. Bytes beyond a message's own length are sent
//!   as they stand in it: whoever makes the message fills them, with 0.
//! * What `emit` made, `parse` gives back.

pub mod emcy;
pub mod heartbeat;
pub mod lss;
pub mod nmt;
pub mod sdo;
pub mod slcan;
pub mod sync;

mod can_id;
mod cob_id;
#[cfg(feature = "embedded-can")]
mod embedded_can;
mod frame;

pub use can_id::CanId;
pub use cob_id::CobId;
pub use frame::Frame;
