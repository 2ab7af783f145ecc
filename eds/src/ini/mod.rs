//! Lines to sections and pairs of key and value, with their positions.
//!
//! rust-ini reads; it knows no positions, and stumbles over much that real files hold. So each line is
//! [classified](classify) first, what rust-ini would misread is kept from it, and what it reads is
//! [put together](zip) with the positions of the lines.

mod classify;
mod zip;

pub(crate) use zip::{IniSection, read};
