//! Whatever comes from the bus, and whenever: a node goes on serving, and a generated one does the same as a simulated one.

use std::{fs, path::Path};

use lexican_runtime::{
    Address,
    od::{Access, DataType},
};
use lexican_tests::{
    generated::{wdga, wv58mr},
    memory::Memory,
    simulated::{Object, Simulated},
    traffic::{Step, play, steps},
};
use proptest::{prelude::*, test_runner::FileFailurePersistence};

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        failure_persistence: Some(Box::new(FileFailurePersistence::Off)),
        ..ProptestConfig::default()
    }
}

fn traffic() -> impl Strategy<Value = Vec<Step>> {
    proptest::collection::vec(any::<u8>(), 0..1500).prop_map(|bytes| steps(&bytes))
}

fn memory() -> Memory {
    Memory::flash(0x1000)
}

/// The device of an EDS, put together at run time: nothing of it is known to the compiler.
fn simulated(file: &str) -> Simulated {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../eds/devices").join(file);
    let bytes = fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    Simulated::of(&lexican_eds::read(file, bytes).dictionary)
}

#[test]
fn a_generated_device_says_what_the_simulated_one_of_the_same_file_says() {
    let [other_wdga, other_wv58mr] = ["wdga.eds", "wv58mr.eds"].map(simulated);
    proptest!(config(300), |(steps in traffic())| {
        let generated = play(wdga::Device::with_storage((), memory()), &steps);
        prop_assert_eq!(generated, play(other_wdga.clone().with_memory(&memory()), &steps));
        let generated = play(wv58mr::Device::with_storage((), memory()), &steps);
        prop_assert_eq!(generated, play(other_wv58mr.clone().with_memory(&memory()), &steps));
    });
}

/// Objects of every service that one can have objects for, all of them writable, without limits.
fn every_service() -> Simulated {
    let communication = [
        (0x1001, 0, 1, 0),
        (0x1003, 0, 1, 0),
        (0x1003, 1, 4, 0),
        (0x1003, 2, 4, 0),
        (0x1005, 0, 4, 0x80),
        (0x1006, 0, 4, 0),
        (0x1007, 0, 4, 0),
        (0x100C, 0, 2, 100),
        (0x100D, 0, 1, 3),
        (0x1010, 1, 4, 1),
        (0x1011, 1, 4, 1),
        (0x1012, 0, 4, 0x8000_0100),
        (0x1014, 0, 4, 0x84),
        (0x1015, 0, 2, 10),
        (0x1016, 1, 4, 0x0005_0064),
        (0x1016, 2, 4, 0),
        (0x1017, 0, 2, 0),
        (0x1018, 1, 4, 0x13),
        (0x1018, 2, 4, 1),
        (0x1018, 3, 4, 1),
        (0x1018, 4, 4, 1),
        (0x1019, 0, 1, 0),
        (0x1020, 1, 4, 0),
        (0x1020, 2, 4, 0),
        (0x1029, 1, 1, 0),
        (0x1200, 1, 4, 0x604),
        (0x1200, 2, 4, 0x584),
        (0x1201, 1, 4, 0x8000_0000),
        (0x1201, 2, 4, 0x8000_0000),
        (0x1F80, 0, 4, 0),
        (0x6003, 0, 4, 0),
        (0x6004, 0, 8, 0x0123_4567_89AB_CDEF),
    ];
    let pdos = [(0x1400, 0x204), (0x1401, 0x304), (0x1800, 0x184), (0x1801, 0x284)];
    let parameters = pdos.into_iter().flat_map(|(index, cob_id)| {
        let values = [(1, 4, cob_id), (2, 1, 0xFF), (3, 2, 0), (5, 2, 0), (6, 1, 0)];
        let mapping = [(0, 1, 1), (1, 4, 0x6003_0020), (2, 4, 0)];
        let parameter = values.map(move |(sub, length, value)| (index, sub, length, value));
        parameter
            .into_iter()
            .chain(mapping.map(move |(sub, length, value)| (index + 0x200, sub, length, value)))
    });
    let numbers = communication.into_iter().chain(parameters);
    let mappable = Access::TPDO.with(Access::RPDO);
    let objects = numbers.map(|(index, sub, length, default)| {
        let mut object = Object::number(index, sub, length, default);
        object.access = object.access.with(if index < 0x2000 { Access(0) } else { mappable });
        object
    });
    let string = Object {
        address: Address::new(0x1008, 0),
        data_type: DataType::VISIBLE_STRING,
        capacity: 60,
        default: b"a name that does not fit into one segment".to_vec(),
        ..Object::number(0x1008, 0, 4, 0)
    };
    Simulated::new(&objects.chain([string]).collect::<Vec<_>>())
}

#[test]
fn a_node_with_every_service_goes_on_serving() {
    let device = every_service();
    proptest!(config(500), |(steps in traffic())| {
        prop_assert!(!play(device.clone().with_memory(&memory()), &steps).is_empty());
    });
}
