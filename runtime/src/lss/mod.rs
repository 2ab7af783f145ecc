//! The LSS slave (CiA 305): a node-ID and a bit rate by wire, for a device without switches.
//!
//! ```text
//!            switch state global 1, selective, end of a fastscan
//! WAITING ───────────────────────────────────────────────────────▶ CONFIGURATION
//!         ◀─────────────────────────────────────────────────────── inquire, configure, activate, store
//!            switch state global 0, any reset
//! ```
//!
//! A node has three node-IDs, each 1 to 127 or 255 for none: the *active* one ([`Node::node_id`](crate::Node::node_id)),
//! the *pending* one, that was configured and becomes the active one with the next reset communication, and the
//! *persistent* one, with which the node starts and begins anew at reset node. "Store configuration" makes the pending one
//! the persistent one. A node without an active node-ID takes LSS messages only, and says nothing but their answers; it
//! boots up as soon as it is given a node-ID and switched to waiting.
//!
//! It is served in every NMT state. What CiA 305 leaves open, this slave does so:
//!
//! * The messages of "switch state selective" and "identify remote slave" are to come in their order, others between them
//!   or not; one that does not match ends the sequence.
//! * A fastscan is for slaves without a node-ID, in waiting state.
//! * After "activate bit timing" the node goes on in the NMT state that it was in.

mod bit_rate;
mod slave;

pub use bit_rate::{BitRate, BitRates};
pub use slave::{Reaction, Slave, State};
