//! The host's side of a CANopen bus.
//!
//! | module | does |
//! |---|---|
//! | [`decode`] | says in the dictionary's words what a frame is |
//! | [`dump`] | reads a device into a dump |
//! | [`log`] | reads logs of a bus, and writes them |
//! | [`simulated`] | devices made of an EDS file at run time |
//! | [`sdo`] | reads and writes values of a node: the SDO client |
//! | [`transport`] | carries frames: one way to a bus a file, chosen by a URL |
//!
//! What speaks a protocol is sans-IO: it is handed frames and the time, and says what to send and until when to wait.

pub mod decode;
pub mod dump;
pub mod log;
pub mod sdo;
pub mod simulated;
pub mod transport;
