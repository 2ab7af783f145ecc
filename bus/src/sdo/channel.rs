//! The identifiers that a client and its server speak on.

use lexican_runtime::{CanId, NodeId};

/// An SDO channel: two identifiers, and the one on which the server's node says that it has booted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Channel {
    /// From the client to the server.
    pub request: CanId,
    /// From the server to the client.
    pub response: CanId,
    /// Where the server's node says that it has booted: then no transfer is open any more.
    pub error_control: CanId,
}

impl Channel {
    /// The default channel of a node: 600h and 580h + node-ID (CiA 301, table 41).
    #[must_use]
    pub const fn default_of(node_id: NodeId) -> Self {
        Self {
            request: CanId::sdo_request(node_id),
            response: CanId::sdo_response(node_id),
            error_control: CanId::error_control(node_id),
        }
    }
}
