//! What there is to send.

use crate::NodeId;

/// Services with a frame to send, a set of bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pending(u16);

impl Pending {
    pub(super) const NOTHING: Self = Self(0x0000);
    /// The boot-up message, before all others.
    pub(super) const BOOT_UP: Self = Self(0x0001);
    /// No frame: objects of the services may have changed, and are to be looked at.
    pub(super) const CONFIGURATION: Self = Self(0x0002);
    /// SYNC.
    pub(super) const SYNC: Self = Self(0x0004);
    /// Emergency messages.
    pub(super) const EMCY: Self = Self(0x0008);
    /// TPDOs.
    pub(super) const PDO: Self = Self(0x0010);
    /// The SDO server's response.
    pub(super) const SDO: Self = Self(0x0020);
    /// A segment of the SDO server's block.
    pub(super) const BLOCK: Self = Self(0x0800);
    /// Anything of the SDO server's.
    pub(super) const SDO_ALL: Self = Self(Self::SDO.0 | Self::BLOCK.0);
    /// Responses and segments of the other SDO servers.
    pub(super) const SERVERS: Self = Self(0x1000);
    /// A heartbeat.
    pub(super) const HEARTBEAT: Self = Self(0x0040);
    /// The answer to node guarding.
    pub(super) const GUARDING: Self = Self(0x0080);
    /// The command that starts all nodes.
    pub(super) const START_ALL: Self = Self(0x0100);
    /// The LSS slave's response.
    pub(super) const LSS: Self = Self(0x0200);
    /// No frame, and no other than the LSS slave's: a node-ID is awaited, or a bit rate is being switched.
    pub(super) const SILENCE: Self = Self(0x0400);

    /// What a node that starts with this node-ID has to send.
    pub(super) const fn of_start(node_id: NodeId) -> Self {
        match node_id.configured() {
            Some(_) => Self::BOOT_UP,
            None => Self::SILENCE,
        }
    }

    /// This and `other`.
    pub(super) const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    pub(super) fn add(&mut self, other: Self) {
        self.0 |= other.0;
    }

    pub(super) fn remove(&mut self, other: Self) {
        self.0 &= !other.0;
    }

    /// Whether `other` is in it.
    pub(super) fn has(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    /// Whether `other` was in it; now it is not.
    pub(super) fn take(&mut self, other: Self) -> bool {
        let had = self.0 & other.0 != 0;
        self.remove(other);
        had
    }
}
