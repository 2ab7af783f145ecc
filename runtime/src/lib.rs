#![doc = include_str!("../README.md")]
//!
//! # The layers
//!
//! Each a folder or file, each knowing only those above it in this list:
//!
//! * [`wire`]: bytes ↔ meaning, one message family a file, no state.
//! * [`od`]: the object dictionary: a table in flash, values in one struct, access with the abort codes of CiA 301.
//! * one service a file or folder: [`sdo`], [`nmt`], [`heartbeat`], [`guarding`], [`emcy`], [`sync`], [`time`],
//!   [`pdo`], [`lss`],
//!   [`storage`].
//! * [`led`]: what the LEDs of a device show, as pure functions.
//! * [`Node`]: ties the services together: [`Node::receive`], [`Node::poll`], [`Node::poll_at`].

#![no_std]

pub mod emcy;
pub mod guarding;
pub mod heartbeat;
pub mod led;
pub mod lss;
pub mod nmt;
pub mod od;
pub mod pdo;
pub mod profile;
pub mod sdo;
pub mod storage;
pub mod sync;
pub mod time;
pub mod wire;

mod abort;
mod address;
mod bus_state;
mod event;
mod instant;
#[cfg(feature = "defmt")]
mod log;
mod node;
mod node_id;

pub use abort::AbortCode;
pub use address::Address;
pub use bus_state::BusState;
pub use bytemuck;
pub use event::{Event, Heard};
pub use instant::Instant;
pub use node::Node;
pub use node_id::NodeId;
pub use od::{Device, Reset};
pub use wire::{
    emcy::Emergency,
    nmt::{NmtCommand, NmtState},
    CanId, Frame,
};
