//! Shared set-up of the tests: a bus with one node on it, dialogues on that bus, and two devices to talk to.

pub mod bus;
pub mod client;

pub mod corpus;
pub mod dialogue;
#[cfg(unix)]
pub mod emulator;
pub mod encoder;
pub mod fixture;
pub mod generated;
pub mod levels;
pub mod line;
pub mod network;
pub mod python;
pub mod sample;
pub mod sdo_client;
pub mod traffic;

pub use lexican_bus::simulated::{self, memory};

/// The first page: its examples run as tests, the build script with the others of this package.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
pub struct FirstPage;
