//! The rules of a device profile are heard when 1000h names the profile, or when the caller does.

use std::{fs, path::Path};

use lexican_eds::{
    Reading,
    diagnostic::Code,
    rules::{self, Levels},
};

fn read(path: &str) -> Reading {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path);
    lexican_eds::read("x.eds", fs::read(path).expect("the file is there"))
}

/// The codes of family ENC that the file has under `profile`; without one, under that of its 1000h.
fn found(reading: &Reading, profile: Option<u16>) -> Vec<&'static str> {
    let levels = Levels::default();
    let found = match profile {
        Some(profile) => rules::check_as(reading, &levels, profile),
        None => rules::check(reading, &levels),
    };
    let codes = found.iter().map(|diagnostic| diagnostic.code);
    let codes = codes.filter(|code| code.family() == "ENC");
    codes.map(Code::as_str).collect()
}

#[test]
fn an_encoder_is_held_against_the_profile_of_encoders_unless_that_is_switched_off() {
    let encoder = read("tests/fixtures/rules/ENC005.eds");
    assert_eq!(rules::profile(&encoder.dictionary), 406);
    assert_eq!(found(&encoder, None), ["ENC005"]);
    assert_eq!(found(&encoder, Some(0)), [""; 0]);
    assert_eq!(found(&encoder, Some(402)), [""; 0]);
}

#[test]
fn another_device_is_held_against_the_profile_of_encoders_when_the_caller_says_so() {
    let other = read("tests/fixtures/rules/OBJ001.fixed.eds");
    assert_eq!(rules::profile(&other.dictionary), 0);
    assert_eq!(found(&other, None), [""; 0]);
    assert!(found(&other, Some(406)).contains(&"ENC002"));
}

#[test]
fn of_a_device_with_several_modules_the_first_one_says_what_encoder_it_is() {
    let text = |kind| format!("[1000]\nDataType=7\nDefaultValue=0xFFFF0196\n[67FF]\nDataType=7\nDefaultValue={kind}\n");
    let read = |kind| lexican_eds::read("x.eds", text(kind).into());
    assert!(!found(&read("0x00020196"), None).contains(&"ENC001"));
    assert!(found(&read("0x00630196"), None).contains(&"ENC001"));
}

/// The files that were written from the profile's own text, and held against it row by row.
#[test]
fn the_profile_keeps_its_own_rules() {
    for file in ["cia406.eds", "cia406-multi.eds"] {
        assert_eq!(found(&read(&format!("eds/devices/{file}")), None), [""; 0], "{file}");
    }
}
