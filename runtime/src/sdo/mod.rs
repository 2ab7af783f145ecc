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
//! * An answer that waits to be sent when the next request comes is dropped: that request's client does not await it any more.
//! * A block is sent a segment a [`poll`](crate::Node::poll), so the driver sets its pace; the client's time begins when the
//!   last one is out. Any request ends it, an acknowledgement by going on behind what it says.
//! * A client that asks for no CRC is offered none.
//! * A value in parts ([`Access::PARTS`](crate::od::Access::PARTS)) goes to the application as it comes, the rest of it when
//!   the client has said that all is right. Its blocks are as long as the buffer.
//! * A download is collected in a buffer and written when it is complete: an abandoned one has changed nothing.
//! * An upload is a snapshot taken when it begins.
//! * The servers beyond the first ([`Channel`]) differ from it in their identifiers only. Each has a buffer of its own: of two
//!   downloads to one object each is stored whole when it is complete, and the later one stays.
//! * Two servers do not know of each other's transfers: of a value in parts that two clients write at once the application gets
//!   the parts of both. It may refuse the part that begins the second download.
//! * Other identifiers in 1201h to 127Fh end that server's transfer without a word. A client that takes away the server that
//!   it is speaking to gets the answer still.
//!
//! Every request in every state (`tests/tests/sdo_states.rs` walks this table):
//!
//! | request | no transfer | `2x` download | `4x` upload | blocks come in | all blocks are in | blocks go out | all blocks are out |
//! |---|---|---|---|---|---|---|---|
//! | `40`, `2x`, `A0`, `C0` | begins | begins | begins | segment | begins | begins | begins |
//! | `0x`, `1x` | refused | taken | refused | segment | refused | refused | refused |
//! | `60`, `70` | refused | refused | answered | segment | refused | refused | refused |
//! | `80` | silence | ends | ends | ends | ends | ends | ends |
//! | `A3` | refused | refused | refused | segment | refused | starts, once | refused |
//! | `A2` | refused | refused | refused | segment | refused | goes on | refused |
//! | `A1` | refused | refused | refused | segment | refused | refused | ends |
//! | `C1` | refused | refused | refused | segment | stores | refused | refused |
//! | `E0` | refused | refused | refused | segment | refused | refused | refused |
//!
//! *Refused* is 05040001h. *Segment*: byte 0 is a sequence number there, with bit 7 for the last; the number 0 is refused with
//! 05040003h, one that does not follow the last is dropped, and 127 or bit 7 is acknowledged.

mod block_download;
mod block_upload;
mod blocks;
mod channel;
mod crc;
mod download;
mod incoming;
mod outgoing;
mod parameter;
mod server;
mod upload;

pub use channel::Channel;
pub use crc::crc;
pub use parameter::before_write;
pub use server::{Answer, Next, Server};

use crate::od::{Access, Device, Entry, ServiceSet};

/// Whether the application gives and takes the value in parts. For a device without such values that is known when it is
/// compiled, and costs nothing.
#[inline]
fn is_in_parts<D: Device>(entry: Entry) -> bool {
    D::SERVICES.has(ServiceSet::PARTS) && entry.access.has(Access::PARTS)
}
