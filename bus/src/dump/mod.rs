//! Reads a device into a [`Dump`](lexican_eds::dump::Dump).
//!
//! What is asked for is an [`Order`]: every value of an EDS, or whatever a [scan](Order::scan) finds. A [`Reader`] asks for one
//! value a [`step`](Reader::step), so that its caller shows how far it is, stops when it likes, and keeps what is there: what a
//! device refuses or does not answer is an answer, too, and a bus that goes away takes nothing with it.

mod error;
mod order;
mod reader;
mod scan;

pub use error::Error;
pub use order::Order;
pub use reader::Reader;
