//! A device made of its file while the test runs: what a generated one has to be equal to.

use std::cmp::Ordering;

use lexican_eds::ir::{self, Dictionary, Entry, NodeId, ObjectCode, Value};
use lexican_runtime::{
    Address,
    od::{Access, DataType},
};

use crate::simulated::{Object, Simulated};

/// The device that `dictionary` describes, with every default. Where the file gives none it is what a good device has.
#[must_use]
pub fn device(dictionary: &Dictionary) -> Simulated {
    let objects = dictionary.objects.iter();
    let entries = objects.flat_map(|object| object.entries.iter().map(move |entry| (object, entry)));
    let objects: Vec<Object> = entries
        .map(|(object, entry)| simulated(dictionary, object, entry))
        .collect();
    Simulated::new(&objects)
}

fn simulated(dictionary: &Dictionary, object: &ir::Object, entry: &Entry) -> Object {
    let value = entry.default.clone().or_else(|| expected(dictionary, object, entry));
    let bytes = |value: &Value| value.to_bytes(entry.data_type, None);
    let zeros = || vec![0; entry.data_type.bytes().unwrap_or(0)];
    let limits = entry.low.as_ref().zip(entry.high.as_ref());
    Object {
        address: Address::new(entry.address.index, entry.address.sub),
        data_type: DataType(u8::try_from(entry.data_type.index()).expect("a data type below 20h")),
        access: access(entry, matches!(value, Some(Value::NodeIdPlus(_)))),
        default: value.as_ref().map_or_else(zeros, bytes),
        limits: limits.map(|(low, high)| (bytes(low), bytes(high))),
        capacity: 0,
    }
}

fn access(entry: &Entry, is_formula: bool) -> Access {
    let facts = [
        (entry.access.readable(), Access::READ),
        (entry.access.writable(), Access::WRITE),
        (is_formula, Access::NODE_ID),
    ];
    let set = facts.into_iter().filter_map(|(is_so, access)| is_so.then_some(access));
    set.fold(Access(0), Access::with)
}

/// What a good device answers where its file gives no default; `None` for 0.
fn expected(dictionary: &Dictionary, object: &ir::Object, entry: &Entry) -> Option<Value> {
    if let Some(number) = identity(dictionary, entry.address) {
        return Some(Value::Unsigned(u64::from(number)));
    }
    let has_sub_indices = matches!(object.code, ObjectCode::Array | ObjectCode::Record);
    let highest = object.entries.last().map_or(0, |last| last.address.sub);
    match (entry.address.index, entry.address.sub) {
        (0x1200, 1) => Some(Value::NodeIdPlus(0x600)),
        (0x1200, 2) => Some(Value::NodeIdPlus(0x580)),
        (0x1003 | 0x1600..=0x17FF | 0x1A00..=0x1BFF, 0) => None,
        (_, 0) if has_sub_indices => Some(Value::Unsigned(u64::from(highest))),
        _ => nearest_to_zero(entry),
    }
}

fn identity(dictionary: &Dictionary, address: ir::Address) -> Option<u32> {
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
