//! The node-ID.

/// A node's number on its network, 1 to 127 (CiA 301, 4.5.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(u8);

impl NodeId {
    /// The node-ID `value`; `None` outside 1 to 127.
    #[must_use]
    pub const fn new(value: u8) -> Option<Self> {
        match value {
            1..=127 => Some(Self(value)),
            _ => None,
        }
    }

    /// 255: a node that has none, and waits for LSS to give it one. Never leaves this crate.
    pub(crate) const NONE: Self = Self(255);

    /// This; `None` for [`NodeId::NONE`].
    #[inline]
    pub(crate) const fn configured(self) -> Option<Self> {
        Self::new(self.0)
    }

    /// The number, 1 to 127.
    #[must_use]
    pub const fn get(self) -> u8 {
        self.0
    }

    /// The value of the EDS formula `$NODEID + base` in an UNSIGNED8 (CiA 306-1, 4.6.2); the sum wraps.
    #[must_use]
    pub const fn plus_u8(self, base: u8) -> u8 {
        base.wrapping_add(self.0)
    }

    /// The value of the EDS formula `$NODEID + base` in an UNSIGNED16.
    #[must_use]
    pub const fn plus_u16(self, base: u16) -> u16 {
        base.wrapping_add(self.0 as u16)
    }

    /// The value of the EDS formula `$NODEID + base` in an UNSIGNED32.
    #[must_use]
    pub const fn plus_u32(self, base: u32) -> u32 {
        base.wrapping_add(self.0 as u32)
    }

    /// The value of the EDS formula `$NODEID + base` in an UNSIGNED64.
    #[must_use]
    pub const fn plus_u64(self, base: u64) -> u64 {
        base.wrapping_add(self.0 as u64)
    }

    /// The value of the EDS formula `$NODEID + base` in an INTEGER8; the sum wraps.
    #[must_use]
    pub const fn plus_i8(self, base: i8) -> i8 {
        base.wrapping_add_unsigned(self.0)
    }

    /// The value of the EDS formula `$NODEID + base` in an INTEGER16.
    #[must_use]
    pub const fn plus_i16(self, base: i16) -> i16 {
        base.wrapping_add(self.0 as i16)
    }

    /// The value of the EDS formula `$NODEID + base` in an INTEGER32.
    #[must_use]
    pub const fn plus_i32(self, base: i32) -> i32 {
        base.wrapping_add(self.0 as i32)
    }

    /// The value of the EDS formula `$NODEID + base` in an INTEGER64.
    #[must_use]
    pub const fn plus_i64(self, base: i64) -> i64 {
        base.wrapping_add(self.0 as i64)
    }
}
