//! CompactPDO (CiA 306-1, 4.4.2): PDOs whose objects have no sections.

use super::entry;
use crate::ir::{AccessType, Address, DataType, Entry, Object, ObjectCode, Value};
use crate::model::{DeviceInfo, Eds};
use crate::span::{Span, Spanned};

/// The sub-indices of a communication parameter, by the bits of CompactPDO (CiA 301, 7.5.2.35 and 37).
const COMMUNICATION: [(&str, DataType); 6] = [
    ("COB-ID used by PDO", DataType::Unsigned32),
    ("Transmission type", DataType::Unsigned8),
    ("Inhibit time", DataType::Unsigned16),
    ("Compatibility entry", DataType::Unsigned8),
    ("Event timer", DataType::Unsigned16),
    ("SYNC start value", DataType::Unsigned8),
];

/// A PDO is not valid: bit 31 of its COB-ID.
const INVALID: u64 = 0x8000_0000;

/// RPDOs or TPDOs.
struct Direction {
    name: &'static str,
    communication: u16,
    mapping: u16,
    count: Option<Spanned<u16>>,
    /// The CAN-ID of the first PDO of node 0; those of the next three follow at a distance of 100h (CiA 301, 7.3.5).
    predefined: u64,
}

/// Adds the PDO objects that CompactPDO stands for, for all PDOs that have no sections.
pub(super) fn add(eds: &Eds, objects: &mut Vec<Object>) {
    let Some(device) = &eds.device_info else { return };
    let Some(compact) = device.compact_pdo.filter(|bits| bits.value != 0) else {
        return;
    };
    let mut added = Vec::new();
    for direction in [receive(device), transmit(device)] {
        let count = direction.count.map_or(0, |count| count.value.min(512));
        for number in 0..count {
            let missing = |base: u16| eds.object(base + number).is_none().then_some(base + number);
            added.extend(
                missing(direction.communication).map(|index| communication(index, number, &direction, compact)),
            );
            added.extend(
                missing(direction.mapping).map(|index| mapping(index, number, &direction, device, compact.span)),
            );
        }
    }
    objects.extend(added);
}

const fn receive(device: &DeviceInfo) -> Direction {
    Direction {
        name: "RPDO",
        communication: 0x1400,
        mapping: 0x1600,
        count: device.nr_of_rx_pdo,
        predefined: 0x200,
    }
}

const fn transmit(device: &DeviceInfo) -> Direction {
    Direction {
        name: "TPDO",
        communication: 0x1800,
        mapping: 0x1A00,
        count: device.nr_of_tx_pdo,
        predefined: 0x180,
    }
}

fn communication(index: u16, number: u16, direction: &Direction, compact: Spanned<u8>) -> Object {
    let supported = (1..)
        .zip(COMMUNICATION)
        .filter(|(sub, _)| compact.value & (1 << (sub - 1)) != 0);
    let mut entries: Vec<Entry> = supported
        .map(|(sub, (name, data_type))| {
            entry::made_up(
                Address::new(index, sub),
                name.to_owned(),
                data_type,
                AccessType::Rw,
                compact.span,
            )
        })
        .collect();
    if let Some(cob_id) = entries.first_mut().filter(|entry| entry.address.sub == 1) {
        cob_id.default = Some(match number {
            0..4 => Value::NodeIdPlus(direction.predefined + 0x100 * u64::from(number)),
            _ => Value::Unsigned(INVALID),
        });
    }
    record(
        index,
        format!("{} {} communication parameter", direction.name, number + 1),
        entries,
        compact.span,
    )
}

/// As many mapping entries as objects of the least length, Granularity, fit into a PDO.
fn mapping(index: u16, number: u16, direction: &Direction, device: &DeviceInfo, at: Span) -> Object {
    let granularity = device.granularity.map_or(8, |granularity| granularity.value);
    let count = 64_u8.checked_div(granularity).unwrap_or(8).max(1);
    let entry = |sub| {
        let name = format!("Mapping entry {sub}");
        entry::made_up(Address::new(index, sub), name, DataType::Unsigned32, AccessType::Rw, at)
    };
    let mut object = record(
        index,
        format!("{} {} mapping parameter", direction.name, number + 1),
        (1..=count).map(entry).collect(),
        at,
    );
    // Nothing is mapped before someone writes it.
    if let Some(sub_zero) = object.entries.first_mut() {
        sub_zero.access = AccessType::Rw;
        sub_zero.default = Some(Value::Unsigned(0));
    }
    object
}

fn record(index: u16, name: String, subs: Vec<Entry>, span: Span) -> Object {
    let highest = subs.last().map_or(0, |entry| entry.address.sub);
    let mut entries = vec![entry::sub_zero(index, highest, span)];
    entries.extend(subs);
    Object {
        index,
        name,
        code: ObjectCode::Record,
        list: None,
        entries,
        links: Vec::new(),
        span,
    }
}
