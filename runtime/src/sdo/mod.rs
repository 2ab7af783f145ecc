//! The SDO server (CiA 301, 7.2.4): a client reads and writes the object dictionary, one value at a time.
//!
//! Served: expedited, segmented and block transfers, both ways, blocks with a CRC if the client wants one.
//!
//! What CiA 301 leaves open, this server does so:
//!
//! * A new initiate during a transfer ends the old one without a word; nothing of it was stored. The new one is answered.
//! * A request shorter than eight bytes is ignored.
//! * An unknown command is refused with [`UNKNOWN_COMMAND`](crate::AbortCode::UNKNOWN_COMMAND) and the multiplexer that it
//!   brought, and ends the transfer. So is a segment that no transfer expects; without a transfer its multiplexer is
//!   0000h:00.
//! * A client's abort is never answered.
//! * A download is collected in a buffer and written when it is complete: an abandoned one has changed nothing.
//! * An upload is a snapshot taken when it begins.

mod block_download;
mod block_upload;
mod blocks;
mod crc;
mod download;
mod incoming;
mod outgoing;
mod server;
mod upload;

pub use crc::crc;
pub use server::{Answer, Next, Server};

use crate::od::{Access, Device, Entry, ServiceSet};

/// Whether the application gives and takes the value in parts. For a device without such values that is known when it is
/// compiled, and costs nothing.
#[inline]
fn is_in_parts<D: Device>(entry: Entry) -> bool {
    D::SERVICES.has(ServiceSet::PARTS) && entry.access.has(Access::PARTS)
}
