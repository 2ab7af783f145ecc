//! 1003h, the pre-defined error field (CiA 301, 7.5.2.3): the newest error in sub-index 1, their number in sub-index 0.

use crate::{
    od::{self, Device},
    wire::emcy::Emergency,
    Address,
};

/// 1003h:00: number of errors, UNSIGNED8; a client empties the history by writing 0.
pub(super) const COUNT: Address = at(0);

const fn at(sub: u8) -> Address {
    Address::new(0x1003, sub)
}

/// Puts an error on top; the oldest falls out when there is no room.
pub(super) fn push<D: Device>(device: &mut D, emergency: Emergency) {
    let room = room(device);
    for newer in (1..room).rev() {
        let value = od::parameter(device, at(newer));
        set(device, newer + 1, value);
    }
    let [information, more, ..] = emergency.manufacturer;
    let [low, high] = emergency.code.to_le_bytes();
    set(device, 1, u32::from_le_bytes([low, high, information, more]));
    let count = u8::try_from(od::parameter(device, COUNT));
    let count = count.unwrap_or(0).saturating_add(1).min(room);
    // A device without 1003h keeps no history.
    let _ = od::set(device, COUNT, &[count]);
}

/// Leaves no error behind.
pub(super) fn clear<D: Device>(device: &mut D) {
    for nth in 0..room(device) {
        set(device, nth + 1, 0);
    }
}

/// How many errors it holds.
fn room<D: Device>(device: &D) -> u8 {
    device.table().elements(COUNT.index)
}

fn set<D: Device>(device: &mut D, sub: u8, value: u32) {
    let _ = od::set(device, at(sub), &value.to_le_bytes());
}
