//! A CANopen slave whose object dictionary is generated from an EDS file.
//!
//! The layers, each a folder, each knowing only those above it in this list:
//!
//! * [`wire`]: bytes ↔ meaning, one message family a file, no state.
//! * [`od`]: the object dictionary: a table in flash, values in one struct, access with the abort codes of CiA 301.
//! * one service a file or folder: [`sdo`], [`nmt`], [`heartbeat`].
//! * [`node`]: ties the services together: [`Node::receive`], [`Node::poll`], [`Node::poll_at`].
//!
//! There is no clock, no allocator, no `unsafe`, no static and no reachable panic in here.
//! Frames and time come in as arguments, frames go out as return values.

#![no_std]

pub mod od;

mod abort;
mod address;
mod node_id;

pub use abort::AbortCode;
pub use address::Address;
pub use bytemuck;
pub use node_id::NodeId;
pub use od::{Device, Reset};
