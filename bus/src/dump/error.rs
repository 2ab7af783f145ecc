//! Why a dump cannot go on.

use std::fmt;

use lexican_eds::ir::NodeId;

use crate::transport;

/// What ends a dump before its time. What was read until then is kept.
#[derive(Debug)]
pub enum Error {
    /// The bus is gone.
    Bus(transport::Error),
    /// The node answers nothing, not even for 1000h.
    Silent(NodeId),
    /// The dump that is to go on was taken from a device with another identity.
    OtherDevice(NodeId),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bus(error) => error.fmt(f),
            Self::Silent(node_id) => write!(
                f,
                "node {} does not answer; check its node-ID, the bit rate, and that it is not stopped",
                node_id.get()
            ),
            Self::OtherDevice(node_id) => write!(
                f,
                "node {} is not the device that the dump was begun with: 1000h or 1018h differ; take a new dump",
                node_id.get()
            ),
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Bus(error) => Some(error),
            Self::Silent(_) | Self::OtherDevice(_) => None,
        }
    }
}

impl From<transport::Error> for Error {
    fn from(error: transport::Error) -> Self {
        Self::Bus(error)
    }
}
