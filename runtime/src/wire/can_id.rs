//! Identifiers on the bus, and the pre-defined connection set.

use core::fmt;

use crate::NodeId;

/// A CAN identifier of 11 or 29 bits, as it is on the bus: the bits that a COB-ID object has beside it (valid, RTR) are
/// not part of it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CanId(u32);

/// Set in a [`CanId`] of 29 bits.
pub(super) const EXTENDED: u32 = 1 << 29;

impl CanId {
    /// 000h: NMT commands.
    pub const NMT: Self = Self(0x000);

    /// 7E4h: what LSS slaves answer (CiA 305, 6.1).
    pub const LSS_RESPONSE: Self = Self(0x7E4);
    /// 7E5h: what the LSS master asks for.
    pub const LSS_REQUEST: Self = Self(0x7E5);

    /// The identifier `number` of 11 bits; `None` above `0x7FF`.
    #[must_use]
    pub const fn standard(number: u32) -> Option<Self> {
        match number {
            0..=0x7FF => Some(Self(number)),
            _ => None,
        }
    }

    /// The identifier `number` of 29 bits; `None` above `0x1FFF_FFFF`.
    #[must_use]
    pub const fn extended(number: u32) -> Option<Self> {
        match number {
            0..=0x1FFF_FFFF => Some(Self(number | EXTENDED)),
            _ => None,
        }
    }

    /// 600h + node-ID: SDO requests to a node, as all here of the generic pre-defined connection set of CiA 301.
    #[inline]
    #[must_use]
    pub const fn sdo_request(node_id: NodeId) -> Self {
        Self(0x600 + node_id.get() as u32)
    }

    /// 580h + node-ID: a node's SDO responses.
    #[inline]
    #[must_use]
    pub const fn sdo_response(node_id: NodeId) -> Self {
        Self(0x580 + node_id.get() as u32)
    }

    /// 700h + node-ID: boot-up, heartbeat and node guarding.
    #[inline]
    #[must_use]
    pub const fn error_control(node_id: NodeId) -> Self {
        Self(0x700 + node_id.get() as u32)
    }

    /// The identifier's number.
    #[must_use]
    pub const fn number(self) -> u32 {
        self.0 & !EXTENDED
    }

    /// Whether it has 29 bits.
    #[must_use]
    pub const fn is_extended(self) -> bool {
        self.0 & EXTENDED != 0
    }

    /// Whether CiA 301 (table 40) keeps it for a service whose identifier cannot be configured: NMT, SDO, error control,
    /// LSS, and what is reserved beside them.
    #[must_use]
    pub const fn is_restricted(self) -> bool {
        matches!(
            self.0,
            0x000..=0x07F | 0x101..=0x180 | 0x581..=0x5FF | 0x601..=0x67F | 0x6E0..=0x6FF | 0x701..=0x7FF
        )
    }

    /// Number and length in one word.
    #[inline]
    pub(super) const fn bits(self) -> u32 {
        self.0
    }

    /// The identifier of [`CanId::bits`].
    #[inline]
    pub(super) const fn from_bits(bits: u32) -> Self {
        Self(bits)
    }
}

impl fmt::Debug for CanId {
    /// `601h` or `00000601h`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = if self.is_extended() { 8 } else { 3 };
        write!(f, "{:0width$X}h", self.number())
    }
}
