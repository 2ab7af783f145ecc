//! PDOs (CiA 301, 7.2.2 and objects 1400h to 1BFFh): objects sent and received without being asked for, in OPERATIONAL.
//!
//! ```text
//! TPDO  type 0          an event, then the next SYNC          1 … 240   every 1st … 240th SYNC
//!       254, 255        an event or the event timer           252       RTR, as sampled at the last SYNC    253   RTR
//! RPDO  0 … 240         takes effect with the next SYNC       254, 255  at once
//! ```
//!
//! An event is what the application says: [`Node::trigger_tpdo`](crate::Node::trigger_tpdo) and
//! [`Node::object_changed`](crate::Node::object_changed).
//!
//! A mapping is resolved when its parameters are written: what is kept of an entry is the place of its row in the table. So
//! sending a PDO is copying values.
//!
//! What CiA 301 leaves open, this slave does so:
//!
//! * No TPDO is sent merely because the node became OPERATIONAL; event timers start then.
//! * Inhibit time and event timer are those of types 254 and 255. A TPDO that is due within its inhibit time waits.
//! * RTR is answered by any TPDO that allows it (bit 30 of its COB-ID clear).
//! * An RPDO longer than its mapping is taken, and the rest of it ignored. A shorter one is not taken; 8210h says so until one
//!   is long enough. 8250h says that an RPDO did not come within its event timer, until it comes. Both carry the PDO's
//!   number in the first two bytes of the manufacturer.
//! * A value that its object's limits do not allow is not stored; the other objects of its RPDO are.
//! * Synchronous PDOs that miss the window (1007h) are dropped.
//! * A BOOLEAN may be mapped with 1 or 8 bits, any other object with as many as it has.
//! * Between 1400h and 1BFFh the application writes by [`Node::write`](crate::Node::write): what it changes through
//!   [`Node::device_mut`](crate::Node::device_mut) takes effect after the next reset.

mod mapping;
mod mpdo;
mod parameter;
mod room;
mod rpdo;
mod set;
mod tpdo;

pub use mapping::Mapped;
pub use parameter::before_write;
pub use room::{Parts, Pdos, Room};
pub use rpdo::Rpdo;
pub use set::{Faults, Set};
pub use tpdo::Tpdo;

use crate::{
    od::{self, Device},
    wire::CobId,
    Address,
};

/// Who sends a PDO.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Direction {
    /// RPDO: parameters at 1400h, mapping at 1600h.
    Receive,
    /// TPDO: 1800h and 1A00h.
    Transmit,
}

impl Direction {
    /// The index of the communication parameters of PDO `number`.
    const fn communication(self, number: u16) -> u16 {
        let first = match self {
            Self::Receive => 0x1400,
            Self::Transmit => 0x1800,
        };
        first + (number.wrapping_sub(1) & 0x01FF)
    }

    /// The index of its mapping.
    const fn mapping(self, number: u16) -> u16 {
        self.communication(number) + 0x0200
    }
}

/// Sub-indices of the communication parameters.
mod sub {
    pub(super) const COB_ID: u8 = 1;
    pub(super) const TRANSMISSION_TYPE: u8 = 2;
    /// In 100 µs.
    pub(super) const INHIBIT_TIME: u8 = 3;
    /// In ms.
    pub(super) const EVENT_TIMER: u8 = 5;
    pub(super) const SYNC_START_VALUE: u8 = 6;
}

/// The COB-ID of the PDO `number`; one that is not valid where there is none.
#[inline(never)] // One copy for all who ask: parameters are read seldom.
fn cob_id<D: Device>(device: &D, direction: Direction, number: u16) -> CobId {
    let index = direction.communication(number);
    CobId(od::configured(device, Address::new(index, sub::COB_ID)).unwrap_or(u32::MAX))
}

/// A parameter of at most 16 bits; 0 where there is none.
#[inline(never)]
fn parameter<D: Device>(device: &D, index: u16, sub: u8) -> u16 {
    u16::try_from(od::parameter(device, Address::new(index, sub))).unwrap_or(0)
}

/// A parameter of 8 bits; 0 where there is none.
fn parameter_u8<D: Device>(device: &D, index: u16, sub: u8) -> u8 {
    u8::try_from(parameter(device, index, sub)).unwrap_or(0)
}
