//! `lexican dump`, and `lexican validate` of a device on a bus

use std::fs;

use lexican_eds::dump::{AbortCode, Answer, Dump};

use crate::{device::Device, lexican::Lexican};

const EDS: &[u8] = include_bytes!("../../../tests/fixtures/rules/DMP007.eds");
/// A device of node-ID 5 that is the one of the EDS, and one that is not.
const GOOD: &[u8] = include_bytes!("../../../tests/fixtures/rules/DMP007.fixed.json");
const OTHER: &[u8] = include_bytes!("../../../tests/fixtures/rules/DMP007.json");

fn lexican() -> Lexican {
    Lexican::with(&[("pump.eds", EDS)])
}

fn read(lexican: &Lexican, name: &str) -> Dump {
    Dump::from_json(&fs::read(lexican.path().join(name)).unwrap()).unwrap()
}

#[test]
fn every_value_of_the_eds_is_read_and_the_file_validates() {
    let (lexican, device) = (lexican(), Device::of(GOOD));
    let arguments = ["dump", "--bus", &device.url, "--node", "5", "--eds", "pump.eds"];
    let ran = lexican.run(&[&arguments[..], &["-o", "node5.json"]].concat());
    assert_eq!(ran.printed(0), "");
    let dump = read(&lexican, "node5.json");
    assert_eq!(dump.objects, Dump::from_json(GOOD).unwrap().objects);
    assert_eq!(dump.device.unwrap().vendor_id, Some(0x9B));
    assert!(dump.taken.unwrap().ends_with('Z'));
    let ran = lexican.run(&["validate", "pump.eds", "node5.json"]);
    assert_eq!(ran.printed(0), "1 device checked: no findings\n");
}

#[test]
fn without_a_file_to_write_to_the_dump_is_printed() {
    let (lexican, device) = (lexican(), Device::of(GOOD));
    let ran = lexican.run(&["dump", "--bus", &device.url, "--node", "5", "--eds", "pump.eds"]);
    assert!(Dump::from_json(ran.printed(0).as_bytes()).is_ok());
}

#[test]
fn a_refusal_is_recorded_and_no_failure() {
    let empty = br#"{"format": "lexican-dump", "version": 1, "node": 5, "objects": {}}"#;
    let (lexican, device) = (lexican(), Device::of(empty));
    let ran = lexican.run(&["dump", "--bus", &device.url, "--node", "5", "--eds", "pump.eds"]);
    let dump = Dump::from_json(ran.printed(0).as_bytes()).unwrap();
    let refused = Answer::Abort(AbortCode::NO_SUCH_OBJECT);
    assert!(!dump.objects.is_empty() && dump.objects.values().all(|answer| *answer == refused));
}

#[test]
fn a_device_on_a_bus_is_validated_as_its_dump_is() {
    let lexican = lexican();
    let validate = |device: &Device| lexican.run(&["validate", "pump.eds", "--bus", &device.url, "--node", "5"]);
    let good = validate(&Device::of(GOOD));
    assert_eq!(good.printed(0), "1 device checked: no findings\n");
    let other = validate(&Device::of(OTHER));
    fs::write(lexican.path().join("other.json"), OTHER).unwrap();
    let recorded = lexican.run(&["validate", "pump.eds", "other.json"]);
    assert_eq!(other.printed(1), recorded.printed(1));
}

#[test]
fn a_node_that_is_not_there_is_named_and_leaves_no_file() {
    let (lexican, device) = (lexican(), Device::of(GOOD));
    let absent = ["--bus", &device.url, "--node", "6", "--timeout", "20"];
    let ran = lexican.run(&[&["dump", "-o", "node6.json"], &absent[..]].concat());
    assert!(ran.failed().contains("node 6 does not answer"), "{ran:?}");
    assert!(!lexican.path().join("node6.json").exists());
    let ran = lexican.run(&[&["validate", "pump.eds"], &absent[..]].concat());
    assert!(ran.failed().contains("node 6 does not answer"), "{ran:?}");
}

#[test]
fn a_bus_that_vanishes_keeps_what_was_read_and_a_resumed_dump_reads_the_rest() {
    let lexican = lexican();
    // Five answers say who the device is.
    let device = Device::that_leaves(GOOD, 8);
    let arguments = ["--eds", "pump.eds", "-o", "node5.json", "--timeout", "100"];
    let ran = lexican.run(&[&["dump", "--bus", &device.url, "--node", "5"], &arguments[..]].concat());
    assert!(ran.failed().contains("what was read is kept"), "{ran:?}");
    assert_eq!(read(&lexican, "node5.json").objects.len(), 3);

    let device = Device::of(GOOD);
    let resume = ["dump", "--bus", &device.url, "--resume", "node5.json"];
    let ran = lexican.run(&[&resume[..], &arguments[..]].concat());
    assert_eq!(ran.printed(0), "");
    assert_eq!(
        read(&lexican, "node5.json").objects,
        Dump::from_json(GOOD).unwrap().objects
    );

    let device = Device::of(OTHER);
    let resume = ["dump", "--bus", &device.url, "--resume", "node5.json"];
    let ran = lexican.run(&[&resume[..], &arguments[..]].concat());
    assert!(
        ran.failed().contains("is not the device that the dump was begun with"),
        "{ran:?}"
    );
}

#[test]
fn two_devices_do_not_go_into_one_file() {
    let ran = lexican().run(&["dump", "--bus", "virtual:none", "--node", "5,6", "-o", "both.json"]);
    assert!(ran.failed().contains("-o node{node}.json"), "{ran:?}");
}

#[test]
fn a_bus_that_is_none_is_refused_with_those_that_are() {
    let ran = lexican().run(&["dump", "--bus", "pigeon:post", "--node", "5"]);
    assert!(ran.failed().contains("pigeon:post"), "{ran:?}");
}
