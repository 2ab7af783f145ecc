//! Storage under any use: what is stored comes back, whole, whenever the power fails.

use std::collections::BTreeMap;

use lexican_runtime::{
    Address,
    od::{Access, DataType, Value},
    storage::{self, Group},
};
use lexican_tests::{
    bus::Bus,
    memory::Memory,
    simulated::{Object, Simulated},
};
use proptest::{collection::vec, prelude::*, sample::select};

/// A value of each length and of each group, one that follows the node-ID, and a string.
const TYPES: [(u16, DataType, usize); 12] = [
    (0x1014, DataType::UNSIGNED32, 4),
    (0x1015, DataType::UNSIGNED16, 2),
    (0x2000, DataType::UNSIGNED8, 1),
    (0x2001, DataType::INTEGER16, 2),
    (0x2002, DataType::UNSIGNED24, 3),
    (0x2003, DataType::INTEGER24, 3),
    (0x2004, DataType::INTEGER40, 5),
    (0x2005, DataType::TIME_DIFFERENCE, 6),
    (0x6000, DataType::UNSIGNED56, 7),
    (0x6001, DataType::REAL64, 8),
    (0x6002, DataType::OCTET_STRING, 30),
    (0x6003, DataType::UNSIGNED32, 4),
];

type Configuration = BTreeMap<u16, Vec<u8>>;

fn object(&(index, data_type, length): &(u16, DataType, usize)) -> Object {
    let is_number = data_type.length() != 0;
    let follows = if index == 0x1014 { Access::NODE_ID } else { Access(0) };
    Object {
        data_type,
        default: if is_number {
            vec![0; length]
        } else {
            b"default".to_vec()
        },
        capacity: if is_number { 0 } else { length },
        ..Object::number(index, 0, 1, 0)
    }
    .with(follows)
}

fn device(memory: &Memory) -> Simulated {
    Simulated::new(&TYPES.iter().map(object).collect::<Vec<_>>()).with_memory(memory)
}

fn switched_on(memory: &Memory) -> Bus<Simulated> {
    Bus::booted(device(memory), 1)
}

/// What a client reads.
fn configuration(bus: &mut Bus<Simulated>) -> Configuration {
    TYPES
        .iter()
        .map(|&(index, data_type, _)| {
            let value = match bus.node().read(Address::new(index, 0)).expect("such an object") {
                Value::Number { bits, .. } => bits.to_le_bytes()[..data_type.length()].to_vec(),
                Value::Bytes(bytes) => bytes.to_vec(),
            };
            (index, value)
        })
        .collect()
}

/// Writes all of it; what is refused, an EMCY identifier or a number that is none, stays as it is.
fn configure(bus: &mut Bus<Simulated>, configuration: &Configuration) {
    for (index, value) in configuration {
        let _ = bus.node().write(Address::new(*index, 0), value);
    }
}

fn any_configuration() -> impl Strategy<Value = Configuration> {
    vec((vec(any::<u8>(), 30), 0..=30_usize), TYPES.len()).prop_map(|values| {
        let values = TYPES.iter().zip(values);
        let value = |(&(index, data_type, length), (bytes, string)): (&(u16, DataType, usize), (Vec<u8>, usize))| {
            let length = if data_type.length() == 0 { string } else { length };
            (index, bytes[..length].to_vec())
        };
        values.map(value).collect()
    })
}

/// Flash, or an EEPROM.
fn any_memory() -> impl Strategy<Value = fn(usize) -> Memory> {
    select(vec![Memory::flash as fn(usize) -> Memory, Memory::eeprom])
}

fn group_of(index: u16) -> Group {
    match index >> 12 {
        1 => Group::COMMUNICATION,
        2 => Group::MANUFACTURER,
        _ => Group::APPLICATION,
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn any_stored_configuration_comes_back(configured in vec(any_configuration(), 1..5), memory in any_memory()) {
        let memory = memory(storage::room(&mut device(&Memory::flash(8))).next_multiple_of(8));
        for configured in configured {
            let mut bus = switched_on(&memory);
            configure(&mut bus, &configured);
            let stored = configuration(&mut bus);
            bus.node().save(Group::ALL).expect("room for all");
            prop_assert_eq!(configuration(&mut switched_on(&memory)), stored);
        }
    }

    #[test]
    fn groups_are_saved_and_restored_independently(
        steps in vec((any_configuration(), any::<bool>(), select(vec![1, 2, 3, 4])), 1..8),
        memory in any_memory(),
    ) {
        let memory = memory(512);
        let defaults = configuration(&mut switched_on(&memory));
        let mut model = defaults.clone();
        let mut bus = switched_on(&memory);
        for (configured, saves, group) in steps {
            let group = Group(group);
            configure(&mut bus, &configured);
            let now = configuration(&mut bus);
            let done = if saves { bus.node().save(group) } else { bus.node().restore(group) };
            prop_assert_eq!(done, Ok(()));
            for (index, value) in &mut model {
                if group.includes(group_of(*index)) {
                    value.clone_from(if saves { &now[index] } else { &defaults[index] });
                }
            }
            prop_assert_eq!(configuration(&mut switched_on(&memory)), model.clone());
        }
    }

    #[test]
    fn a_dictionary_with_other_objects_takes_what_fits(
        configured in any_configuration(),
        gone in vec(any::<bool>(), TYPES.len()),
        other in vec(select(vec![None, Some(DataType::UNSIGNED8), Some(DataType::UNSIGNED64)]), TYPES.len()),
    ) {
        let memory = Memory::flash(512);
        let mut bus = switched_on(&memory);
        configure(&mut bus, &configured);
        let stored = configuration(&mut bus);
        bus.node().save(Group::ALL).expect("room for all");
        let kept = TYPES.iter().zip(gone).filter(|(_, gone)| !gone).map(|(kind, _)| kind);
        let changed: Vec<_> = kept.zip(other).map(|(&(index, data_type, length), other)| match other {
            Some(other) if index != 0x1014 => (index, other, other.length()),
            _ => (index, data_type, length),
        }).collect();
        let mut objects: Vec<Object> = changed.iter().map(object).collect();
        objects.push(Object::number(0x3000, 0, 2, 0x1234));
        objects.push(Object::number(0x3001, 0, 2, 0));
        let mut bus = Bus::booted(Simulated::new(&objects).with_memory(&memory), 1);
        for (index, data_type, length) in changed {
            let value = bus.node().read(Address::new(index, 0)).expect("such an object");
            let before = TYPES.iter().find(|kind| kind.0 == index).expect("of these");
            if data_type.length() == 0 {
                prop_assert_eq!(value.to_bytes(), &stored[&index]);
            } else {
                let bytes = value.bits().to_le_bytes()[..length].to_vec();
                let fits = before.2 == length && before.1.length() != 0 || stored[&index].len() == length;
                let expected = if fits { stored[&index].clone() } else { vec![0; length] };
                prop_assert!(bytes == expected || before.1.length() == 0, "{:04X}: {:?} {:?}", index, bytes, expected);
            }
        }
        prop_assert_eq!(bus.node().read(Address::new(0x3000, 0)).expect("new").bits(), 0x1234);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3))]

    #[test]
    fn a_write_torn_at_any_byte_leaves_the_old_or_the_new_configuration(
        first in any_configuration(),
        second in any_configuration(),
        third in any_configuration(),
        memory in any_memory(),
    ) {
        // Both slots are in use, so that what is torn lies over an older image.
        let memory = memory(256);
        let mut bus = switched_on(&memory);
        for configured in [first, second] {
            configure(&mut bus, &configured);
            bus.node().save(Group::ALL).expect("room for all");
        }
        let old = configuration(&mut bus);
        let mut written = 0;
        loop {
            let torn = memory.copy();
            let mut bus = switched_on(&torn);
            configure(&mut bus, &third);
            let new = configuration(&mut bus);
            torn.fail_after(written);
            let saved = bus.node().save(Group::ALL);
            torn.power_on();
            let found = configuration(&mut switched_on(&torn));
            if saved.is_ok() {
                prop_assert_eq!(&found, &new);
                break;
            }
            prop_assert!(found == old || found == new, "torn after {} bytes", written);
            // The next save goes well.
            let mut bus = switched_on(&torn);
            configure(&mut bus, &third);
            let again = configuration(&mut bus);
            bus.node().save(Group::ALL).expect("the power is back");
            prop_assert_eq!(configuration(&mut switched_on(&torn)), again);
            written += 1;
        }
        prop_assert!(written > 100);
    }
}
