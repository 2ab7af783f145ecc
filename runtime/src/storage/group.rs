//! Which parameters are stored together.

use crate::od::{Access, DataType, Entry};

/// A group of parameters: a sub-index of 1010h and 1011h, 1 to 127; from 128 on, what has none.
///
/// What is in a group from 128 on outlives every restore, and no `save` of a client stores it: the application does
/// ([`Node::save`](crate::Node::save)). So data are kept that are stored without being told to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Group(pub u8);

impl Group {
    /// 1: all that is stored, but for the groups from 128 on.
    pub const ALL: Self = Self(1);
    /// 2: communication parameters, 1000h to 1FFFh.
    pub const COMMUNICATION: Self = Self(2);
    /// 3: application parameters, 6000h to 9FFFh.
    pub const APPLICATION: Self = Self(3);
    /// 4: the manufacturer's parameters, 2000h to 5FFFh.
    pub const MANUFACTURER: Self = Self(4);

    /// Whether what belongs to `other` is in this group.
    #[must_use]
    pub fn includes(self, other: Self) -> bool {
        self == other || self == Self::ALL && other.0 < 0x80
    }

    /// The group of a value that a client may read and write, `None` of others, and of what is no configuration: process
    /// data, the error history, DOMAINs, commands.
    #[must_use]
    pub fn of(entry: Entry) -> Option<Self> {
        let access = entry.access;
        let is_process_data = access.has(Access::RPDO) && !access.has(Access::TPDO);
        let is_set = access.has(Access::READ.with(Access::WRITE));
        if !is_set || is_process_data || entry.data_type == DataType::DOMAIN {
            return None;
        }
        match entry.index {
            0x1003 | 0x1010 | 0x1011 | 0x1023..=0x1026 | 0x1F50..=0x1F5F => None,
            0x1000..=0x1FFF => Some(Self::COMMUNICATION),
            0x2000..=0x5FFF => Some(Self::MANUFACTURER),
            0x6000..=0x9FFF => Some(Self::APPLICATION),
            _ => None,
        }
    }
}
