//! Which of the optional services a device has.

use super::{Access, Row};

/// A set of optional services: those that a dictionary has objects for, and LSS and multiplexed PDOs, which have
/// none.
///
/// A generated device says its own in [`Device::SERVICES`](super::Device::SERVICES): a constant, so that a service that
/// is not in it is not compiled in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ServiceSet(u16);

impl ServiceSet {
    /// No optional service: NMT, SDO and, with 1017h, the heartbeat are always there.
    pub const NONE: Self = Self(0x0000);
    /// SYNC: 1005h.
    pub const SYNC: Self = Self(0x0001);
    /// Node guarding and life guarding: 100Ch.
    pub const NODE_GUARDING: Self = Self(0x0002);
    /// Storing and restoring parameters: 1010h or 1011h.
    pub const STORAGE: Self = Self(0x0004);
    /// TIME, consumed: 1012h.
    pub const TIME: Self = Self(0x0008);
    /// Emergency messages: 1014h.
    pub const EMCY: Self = Self(0x0010);
    /// Watching the heartbeats of others: 1016h.
    pub const HEARTBEAT_CONSUMER: Self = Self(0x0020);
    /// Verify configuration: 1020h.
    pub const VERIFY_CONFIGURATION: Self = Self(0x0040);
    /// What an error does to the NMT state: 1029h.
    pub const ERROR_BEHAVIOUR: Self = Self(0x0080);
    /// SDO servers beyond the first: 1201h to 127Fh.
    pub const SDO_SERVERS: Self = Self(0x0100);
    /// RPDOs: 1400h to 15FFh.
    pub const RPDO: Self = Self(0x0200);
    /// TPDOs: 1800h to 19FFh.
    pub const TPDO: Self = Self(0x0400);
    /// How the node starts: 1F80h.
    pub const START_UP: Self = Self(0x0800);
    /// The layer setting services (CiA 305): no object says so, but `LSS_Supported` of an EDS.
    pub const LSS: Self = Self(0x1000);
    /// Values that the application gives and takes in parts: entries with [`Access::PARTS`].
    pub const PARTS: Self = Self(0x2000);
    /// SYNC, produced: 1006h.
    pub const SYNC_PRODUCER: Self = Self(0x4000);
    /// Multiplexed PDOs: no object says so, but `GroupMessaging` of an EDS.
    pub const MPDO: Self = Self(0x8000);
    /// All but multiplexed PDOs, for a device whose dictionary is known at run time only: its objects decide then.
    pub const ALL: Self = Self(0x7FFF);

    /// The services that a table of these rows has objects for.
    #[must_use]
    pub const fn of(rows: &[Row]) -> Self {
        let mut set = Self::NONE;
        let mut row = 0;
        while row < rows.len() {
            set = set.with(Self::of_object(rows[row].index()));
            if rows[row].access().has(Access::PARTS) {
                set = set.with(Self::PARTS);
            }
            row += 1;
        }
        set
    }

    /// The service that the object at `index` belongs to.
    const fn of_object(index: u16) -> Self {
        match index {
            0x1005 => Self::SYNC,
            0x1006 => Self::SYNC_PRODUCER,
            0x100C => Self::NODE_GUARDING,
            0x1010 | 0x1011 => Self::STORAGE,
            0x1012 => Self::TIME,
            0x1014 => Self::EMCY,
            0x1016 => Self::HEARTBEAT_CONSUMER,
            0x1020 => Self::VERIFY_CONFIGURATION,
            0x1029 => Self::ERROR_BEHAVIOUR,
            0x1201..=0x127F => Self::SDO_SERVERS,
            0x1400..=0x15FF => Self::RPDO,
            0x1800..=0x19FF => Self::TPDO,
            0x1F80 => Self::START_UP,
            _ => Self::NONE,
        }
    }

    /// These and `others`.
    #[must_use]
    pub const fn with(self, others: Self) -> Self {
        Self(self.0 | others.0)
    }

    /// Whether any of `others` is in it.
    #[must_use]
    pub const fn has(self, others: Self) -> bool {
        self.0 & others.0 != 0
    }
}

#[cfg(test)]
mod tests {
    use super::{Row, ServiceSet};
    use crate::od::{Access, DataType};

    const ROWS: [Row; 3] = [
        Row::value(0x1005, 0, DataType::UNSIGNED32, Access::READ, 0),
        Row::value(0x1200, 1, DataType::UNSIGNED32, Access::READ, 4),
        Row::value(0x19FF, 1, DataType::UNSIGNED32, Access::READ, 8),
    ];

    #[test]
    fn a_service_is_in_the_set_when_it_has_objects() {
        assert_eq!(ServiceSet::of(&ROWS), ServiceSet::SYNC.with(ServiceSet::TPDO));
        assert!(ServiceSet::of(&ROWS).has(ServiceSet::TPDO.with(ServiceSet::RPDO)));
        assert!(!ServiceSet::of(&ROWS).has(ServiceSet::SDO_SERVERS));
    }
}
