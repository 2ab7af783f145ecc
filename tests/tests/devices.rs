//! The encoders' EDS files, held against the tables of their manuals.
//!
//! `tables/*.tsv` were cut out of the manuals' text by a program that never saw the EDS files, so the two agree only when both are right.
//! Where they may differ, an erratum in `docs/errata.md` says why, and it is named here.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on stops")]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use lexican_eds::ir::{DataType, Dictionary, Entry, ObjectCode};

/// What we decided instead of a manual's row, by index: data types and access, comma separated.
type Errata = &'static [(u16, &'static str, &'static str)];

/// An object: its sub-indices, their data types and access, each comma separated.
type Facts = (String, String, String);

const WDGA: Errata = &[
    (0x2105, "UNSIGNED8,UNSIGNED8,UNSIGNED32", "const,rw,rw"),
    (
        0x2502,
        "UNSIGNED8,UNSIGNED32,UNSIGNED32,UNSIGNED32,UNSIGNED32,UNSIGNED32",
        "const,ro,ro,ro,ro,ro",
    ),
    (
        0x2500,
        "UNSIGNED8,INTEGER16,INTEGER16,INTEGER16,INTEGER16,INTEGER16",
        "const,ro,rwr,rwr,ro,ro",
    ),
];

const WV58MR: Errata = &[
    (0x1A00, "UNSIGNED8,UNSIGNED32,UNSIGNED32", "const,ro,ro"),
    (0x6003, "UNSIGNED32", "rw"),
];

#[test]
fn the_wdga_has_every_object_of_tables_6_1_to_6_12() {
    for file in ["wdga.eds", "wdga-st.eds", "wdga.dcf"] {
        assert_eq!(facts(&read(file)), manual("wdga.tsv", WDGA), "{file}");
    }
}

#[test]
fn the_wv58mr_has_every_object_of_chapter_5_7_2() {
    for file in ["wv58mr.eds", "wv58mr-st.eds", "wv58mr.dcf"] {
        assert_eq!(facts(&read(file)), manual("wv58mr.tsv", WV58MR), "{file}");
    }
}

#[test]
fn the_multiturn_wdga_tells_itself_apart_from_the_singleturn_one_where_the_manual_does() {
    let differing = differing_defaults("wdga.eds", "wdga-st.eds");
    assert_eq!(differing, [0x1000, 0x1008, 0x6502]);
}

#[test]
fn the_multiturn_wv58mr_tells_itself_apart_from_the_singleturn_one_where_the_manual_does() {
    let differing = differing_defaults("wv58mr.eds", "wv58mr-st.eds");
    assert_eq!(differing, [0x1000, 0x6002, 0x6502, 0x650A]);
}

#[test]
fn cia_406_has_every_object_of_the_profile_with_one_channel_and_with_254() {
    let (single, multi) = (read("cia406.eds"), read("cia406-multi.eds"));
    let mut objects = 0;
    for row in rows("cia406.tsv") {
        let [_, index, code, channels, data_type, access, mappable] = row.as_slice() else {
            panic!("{row:?}")
        };
        objects += 1;
        let index = u16::from_str_radix(index, 16).unwrap();
        let channels: usize = channels.parse().unwrap();
        let found: Vec<_> = [&single, &multi].into_iter().filter_map(|d| d.object(index)).collect();
        assert!(!found.is_empty(), "{index:04X}");
        for object in found {
            // Erratum: 650Ah has a count and three values.
            let entries = if index == 0x650A { 4 } else { channels + 1 };
            match object.code {
                ObjectCode::Var => assert_eq!(code, "VAR", "{index:04X}"),
                _ => assert!(
                    object.entries.len() == entries || object.entries.len() == 2,
                    "{index:04X}"
                ),
            }
            let value = object.entries.last().unwrap();
            assert_eq!(value.data_type.name(), data_type, "{index:04X}");
            assert_eq!(value.pdo_mapping, mappable == "yes", "{index:04X}");
            // Errata: 6020h is measured, 6301h and 6302h go into TPDOs.
            let access = match index {
                0x6020 => "ro",
                0x6301 | 0x6302 => "rwr",
                _ => access,
            };
            assert_eq!(value.access.name(), access, "{index:04X}");
        }
    }
    assert_eq!(objects, 52);
    assert_eq!(multi.object(0x6020).unwrap().entries.len(), 255);
}

#[test]
fn the_high_precision_values_keep_their_64_and_40_bits() {
    let wdga = read("wdga.eds");
    let data_type = |index: u16| wdga.object(index).unwrap().entries[0].data_type;
    assert_eq!(data_type(0x6008), DataType::Unsigned64);
    assert_eq!(data_type(0x6510), DataType::Unsigned40);
    let revolutions = wdga.object(0x6510).unwrap().entries[0].default.clone().unwrap();
    assert_eq!(
        revolutions.to_bytes(DataType::Unsigned40, None),
        [0, 0, 0, 0, 0x80],
        "0080 0000 0000h in table 6.10"
    );
}

/// Every object, as the tables have them.
fn facts(dictionary: &Dictionary) -> BTreeMap<u16, Facts> {
    let joined = |entries: &[Entry], fact: fn(&Entry) -> String| entries.iter().map(fact).collect::<Vec<_>>().join(",");
    dictionary
        .objects
        .iter()
        .map(|object| {
            let subs = joined(&object.entries, |entry| format!("{:02X}", entry.address.sub));
            let types = joined(&object.entries, |entry| entry.data_type.name().to_owned());
            let access = joined(&object.entries, |entry| entry.access.name().to_owned());
            (object.index, (subs, types, access))
        })
        .collect()
}

/// What the manual says, with the errata applied.
fn manual(table: &str, errata: Errata) -> BTreeMap<u16, Facts> {
    let mut objects: BTreeMap<_, _> = rows(table)
        .iter()
        .map(|row| {
            let [_, index, subs, types, access] = row.as_slice() else {
                panic!("{row:?}")
            };
            let facts = (subs.clone(), types.clone(), access.clone());
            (u16::from_str_radix(index, 16).unwrap(), facts)
        })
        .collect();
    for (index, types, access) in errata {
        let printed = objects.get_mut(index).unwrap();
        let decided = (printed.0.clone(), (*types).to_owned(), (*access).to_owned());
        assert_ne!(*printed, decided, "{index:04X} is no erratum");
        *printed = decided;
    }
    objects
}

/// The indices whose values after power-on differ.
fn differing_defaults(one: &str, other: &str) -> Vec<u16> {
    let (one, other) = (read(one), read(other));
    let defaults = |d: &Dictionary, index: u16| -> Vec<_> {
        let entries = &d.object(index).unwrap().entries;
        entries.iter().map(|entry| entry.default.clone()).collect()
    };
    let mut indices: Vec<u16> = one.objects.iter().map(|object| object.index).collect();
    indices.retain(|&index| defaults(&one, index) != defaults(&other, index));
    indices
}

fn read(file: &str) -> Dictionary {
    let path = root().join("../eds/devices").join(file);
    let bytes = std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    lexican_eds::read(file, bytes).dictionary
}

/// The rows of a table below its heading.
fn rows(table: &str) -> Vec<Vec<String>> {
    let text = std::fs::read_to_string(root().join("tables").join(table)).unwrap();
    let rows = text.lines().skip(1);
    rows.map(|line| line.split('\t').map(str::to_owned).collect()).collect()
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_owned()
}
