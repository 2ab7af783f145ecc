//! The forms of encoders that the fixtures of family ENC do not show.

use std::{fs, path::Path};

use lexican_eds::rules::{self, Levels};

/// What is found in `fixture` after each `(old, new)` was exchanged, each as code and message.
fn found(fixture: &str, changes: &[(&str, &str)]) -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/rules");
    let mut text = fs::read_to_string(folder.join(fixture)).expect("the fixture is there");
    for (old, new) in changes {
        assert!(text.contains(old), "{fixture} has no {old}");
        text = text.replace(old, new);
    }
    let reading = lexican_eds::read("x.eds", text.into());
    let found = rules::check(&reading, &Levels::default());
    let of_encoders = found.iter().filter(|diagnostic| diagnostic.code.family() == "ENC");
    of_encoders
        .map(|diagnostic| format!("{}: {}", diagnostic.code, diagnostic.message))
        .collect()
}

const NOTHING: [&str; 0] = [];

/// Takes the object at `index` out of a fixture.
fn without(index: &str) -> [(String, String); 2] {
    let listed = (format!("=0x{index}\n"), "=0x2000\n".to_owned());
    [listed, (format!("[{index}"), "[2000".to_owned())]
}

fn found_without(fixture: &str, index: &str, more: &[(&str, &str)]) -> Vec<String> {
    let taken = without(index);
    let taken = taken.iter().map(|(old, new)| (old.as_str(), new.as_str()));
    let changes: Vec<(&str, &str)> = taken.chain(more.iter().copied()).collect();
    found(fixture, &changes)
}

const MULTI_TURN: &str = "0x00020196";
const LINEAR: &str = "0x00080196";
const MULTI_SENSOR: &str = "0x000A0196";

#[test]
fn a_linear_encoder_has_no_revolutions() {
    let good = "ENC001.fixed.eds";
    assert_eq!(
        found_without(good, "6502", &[]),
        ["ENC002: object 6502h, number of distinguishable revolutions, is missing; every encoder has it"]
    );
    assert_eq!(found_without(good, "6502", &[(MULTI_TURN, LINEAR)]), NOTHING);
}

#[test]
fn an_encoder_of_several_sensors_has_its_positions_at_6020() {
    assert_eq!(
        found("ENC001.fixed.eds", &[(MULTI_TURN, MULTI_SENSOR)]),
        ["ENC002: object 6020h, position values for multi-sensor devices, is missing; every encoder has it"]
    );
    assert_eq!(found("ENC012.fixed.eds", &[]), NOTHING);
}

#[test]
fn who_says_that_he_is_of_class_c1_needs_no_object_of_class_c2() {
    assert_eq!(found("ENC003.eds", &[("=0x00000002", "=0x00000001")]), NOTHING);
    let class_3 = found("ENC003.eds", &[("=0x00000002", "=0x00000003")]);
    assert_eq!(
        class_3,
        ["ENC003: object 6508h, operating time, is missing; class C2 demands it"]
    );
}

#[test]
fn without_650e_the_objects_tell_the_class() {
    assert_eq!(
        found_without("ENC003.eds", "650E", &[]),
        ["ENC003: object 6508h, operating time, is missing; class C2, which the others are of, demands it"]
    );
    // One object of class C2 makes no encoder of that class.
    assert_eq!(found("ENC008.fixed.eds", &[]), NOTHING);
    assert_eq!(found("ENC017.fixed.eds", &[]), NOTHING);
}

#[test]
fn a_preset_of_several_sensors_is_of_either_versions_type() {
    let type_of_preset = |number| {
        let old = "ParameterName=Preset value, channel 1\nObjectType=0x7\nDataType=0x0004";
        let new = old.replace("0x0004", number);
        found("ENC012.fixed.eds", &[(old, &new)])
    };
    assert_eq!(type_of_preset("0x0007"), NOTHING);
    assert_eq!(
        type_of_preset("0x0006"),
        [
            "ENC005: 6010sub1, preset values for multi-sensor devices, is UNSIGNED16; CiA 406 gives it INTEGER32 or UNSIGNED32"
        ]
    );
}

#[test]
fn a_cam_wants_registers_and_registers_want_a_cam() {
    assert_eq!(
        found_without("ENC010.fixed.eds", "6300", &[]),
        ["ENC010: 6301h is there, but 6300h, cam state register, is not"]
    );
    let mut registers = found("ENC011.fixed.eds", &[("640", "630"), ("0x0004", "0x0005")]);
    registers.retain(|finding| finding.starts_with("ENC010"));
    assert_eq!(
        registers,
        [
            "ENC010: 6300h is there, but 6310h, cam low limit, is not",
            "ENC010: 6300h is there, but 6320h, cam high limit, is not",
            "ENC010: 6300h is there, but 6330h, cam hysteresis, is not",
        ]
    );
}

#[test]
fn a_measuring_range_is_units_times_revolutions_at_most() {
    let range = |value| found("ENC003.eds", &[("=33554432", value), ("=0x00000002", "=0x00000001")]);
    assert_eq!(range("=33554432"), NOTHING);
    assert_eq!(
        range("=33554433"),
        ["ENC014: 6002h is 33554433; 4096 revolutions of 8192 units are 33554432"]
    );
}

#[test]
fn the_profiles_version_may_be_written_in_two_ways() {
    let version = |value| found("ENC020.fixed.eds", &[("0x01050302", value)]);
    assert_eq!(version("0x01050320"), NOTHING);
    assert_eq!(version("0x01050400"), NOTHING);
    assert_eq!(
        version("0x00000000"),
        ["ENC020: 6507h says version 0.0 of CiA 406, which does not exist"]
    );
}

#[test]
fn a_type_that_cannot_be_read_is_not_held_against_the_profile() {
    let old = "ParameterName=Position value\nObjectType=0x7\nDataType=0x0007";
    assert_eq!(
        found("ENC001.fixed.eds", &[(old, &old.replace("0x0007", "U32"))]),
        NOTHING
    );
}
