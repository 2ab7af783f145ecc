//! The SDO client (CiA 301, 7.2.4.3): reads and writes values of a node's object dictionary. *Upload* is reading, *download* is
//! writing.
//!
//! [`Client`] is sans-IO, as the runtime's server, and shares with it the messages ([`lexican_runtime::wire::sdo`]) but no state:
//! an error of the one does not hide in the other. [`upload`] and [`download`] drive it over a [`Transport`](crate::transport).
//!
//! # States
//!
//! One transfer at a time. What is sent to enter a state, what the server answers, and where that leads:
//!
//! | state | sent | answer | next |
//! |---|---|---|---|
//! | upload: opened | `40` | `4x` with the value | done |
//! | | | `40`, `41` with or without the size | segments; blocks when that pays, see [`Manner::Fastest`] |
//! | upload: segments | `60`, `70` | `0t` up to seven bytes, `t` as asked | segments, or done at the last one |
//! | block upload: opened | `A4` | `C0` to `C6` | a block, by `A3` |
//! | | | `4x`: the server takes the plain protocol | as of upload |
//! | block upload: a block | `A3`, `A2` | `01` to `7F` in order, `81` to `FF` the last | a block by `A2`, which asks for what is lost once more; the end |
//! | block upload: the end | `A2` | `C1` with the CRC | done, by `A1` |
//! | download: opened | `2x` | `60` | done when the value stood in the request; segments |
//! | download: segments | `0t`, `1t` | `20`, `30` | segments, done after the last one |
//! | block download: opened | `C6` | `A0`, `A4` with the block's size | a block |
//! | block download: a block | `01` to `7F` | `A2` with the last number that came | a block, from what is lost on; the end |
//! | block download: the end | `C1` with the CRC | `A1` | done |
//!
//! In every state: `80` ends the transfer with the server's abort code; what breaks the protocol is answered by `80` and the
//! code that says how; silence ends the wait after [`Patience::timeout`]. Silence and broken transfers, and a boot-up message,
//! begin the transfer anew while there are [`Patience::attempts`].
//!
//! # What is passed over
//!
//! Frames of other identifiers and of less than eight bytes; the answer for another address and any answer before the transfer
//! is open, which come late for a transfer that was given up; the same answer a second time.

mod attempt;
mod block_download;
mod block_upload;
mod channel;
mod client;
mod download;
mod drive;
mod failure;
mod step;
mod upload;

pub use channel::Channel;
pub use client::{Client, Manner, Patience};
pub use drive::{Clock, download, upload};
pub use failure::Failure;
