//! A dump as JSON: format `lexican-dump`, version 1, described in the repository's docs/dump-format.md.
//!
//! Written by hand, one address a line, so that two dumps can be compared by any diff; read by serde, so that whatever
//! order or layout another tool gives it is fine.

mod error;
mod objects;
mod read;
mod values;
mod write;

pub use error::JsonError;

/// What `"format"` holds in every dump.
const FORMAT: &str = "lexican-dump";
/// The version that is written, and the newest one that is read.
const VERSION: u64 = 1;
