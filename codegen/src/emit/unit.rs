//! The units of the standard's objects. An EDS has no keyword for them.

use lexican_eds::ir::Address;

/// The unit of the value at `address`, where CiA 301 sets it.
pub(crate) fn unit(address: Address) -> Option<&'static str> {
    match (address.index, address.sub) {
        // Communication cycle period and length of the synchronous window.
        (0x1006 | 0x1007, 0) => Some("µs"),
        // Guard time and producer heartbeat time; the event timer of a PDO.
        (0x100C | 0x1017, 0) | (0x1400..=0x15FF | 0x1800..=0x19FF, 5) => Some("ms"),
        // Inhibit time of EMCY and of a PDO.
        (0x1015, 0) | (0x1400..=0x15FF | 0x1800..=0x19FF, 3) => Some("multiples of 100 µs"),
        _ => None,
    }
}
