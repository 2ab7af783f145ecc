//! What a file leaves open, as a good device has it.

use std::cmp::Ordering;

use lexican_eds::ir::{Address, Dictionary, Entry, NodeId, Object, ObjectCode, Value};

/// `dictionary` with a default for every value that cannot be 0: what the device is, how many sub-indices an object has, the
/// COB-IDs of the SDO server, a number within limits.
#[must_use]
pub fn complete(dictionary: &Dictionary) -> Dictionary {
    let mut complete = dictionary.clone();
    for object in &mut complete.objects {
        let highest = object.entries.last().map_or(0, |last| last.address.sub);
        let count = has_sub_indices(object).then_some(highest);
        for entry in object.entries.iter_mut().filter(|entry| entry.default.is_none()) {
            entry.default = expected(dictionary, entry, count);
        }
    }
    complete
}

fn has_sub_indices(object: &Object) -> bool {
    let counts_what_is_in_use = matches!(object.index, 0x1003 | 0x1600..=0x17FF | 0x1A00..=0x1BFF);
    matches!(object.code, ObjectCode::Array | ObjectCode::Record) && !counts_what_is_in_use
}

/// `count` is the highest sub-index, of an object whose sub-index 0 says it.
fn expected(dictionary: &Dictionary, entry: &Entry, count: Option<u8>) -> Option<Value> {
    if let Some(number) = identity(dictionary, entry.address) {
        return Some(Value::Unsigned(u64::from(number)));
    }
    match (entry.address.index, entry.address.sub, count) {
        (0x1200, 1, _) => Some(Value::NodeIdPlus(0x600)),
        (0x1200, 2, _) => Some(Value::NodeIdPlus(0x580)),
        (_, 0, Some(highest)) => Some(Value::Unsigned(u64::from(highest))),
        _ => nearest_to_zero(entry),
    }
}

fn identity(dictionary: &Dictionary, address: Address) -> Option<u32> {
    let device = &dictionary.device;
    match (address.index, address.sub) {
        (0x1018, 1) => device.vendor_number,
        (0x1018, 2) => device.product_number,
        (0x1018, 3) => device.revision_number,
        (0x1018, 4) => dictionary.commissioning.as_ref()?.lss_serial_number,
        _ => None,
    }
}

/// The limit that 0 does not keep.
fn nearest_to_zero(entry: &Entry) -> Option<Value> {
    let zero = Value::from_bytes(&vec![0; entry.data_type.bytes()?], entry.data_type)?;
    let compared = |limit: &Value| zero.compare(limit, NodeId::new(1));
    let low = entry
        .low
        .as_ref()
        .filter(|low| compared(low).is_some_and(Ordering::is_lt));
    let high = entry
        .high
        .as_ref()
        .filter(|high| compared(high).is_some_and(Ordering::is_gt));
    low.or(high).cloned()
}
