//! The EDS as zencan's TOML.

use std::{collections::BTreeMap, fmt::Write as _};

use crate::eds;

/// The objects that zencan-build makes by itself.
fn is_builtin(index: u16) -> bool {
    matches!(index, 0x1000 | 0x1001 | 0x1008..=0x100A | 0x1010 | 0x1017 | 0x1018 | 0x1400..=0x1BFF)
}

/// The TOML of the EDS at `file`.
pub fn config(file: &str) -> String {
    let mut text =
        "device_name = \"bench\"\nheartbeat_period = 0\n\n[identity]\nvendor_id = 0x1234\nproduct_code = 2\n\
                    revision_number = 3\n\n[pdos]\nnum_rpdo = 0\nnum_tpdo = 4\n"
            .to_owned();
    let mut objects: BTreeMap<u16, Vec<eds::Entry>> = BTreeMap::new();
    for entry in eds::read(file) {
        objects.entry(entry.index).or_default().push(entry);
    }
    for (index, entries) in objects.iter().filter(|(index, _)| !is_builtin(**index)) {
        write!(
            text,
            "\n[[objects]]\nindex = {index:#06x}\nparameter_name = \"o{index:04x}\"\n"
        )
        .unwrap();
        if let [entry] = entries.as_slice() {
            write!(text, "object_type = \"var\"\n{}", value(entry)).unwrap();
            continue;
        }
        text += "object_type = \"record\"\n";
        for entry in entries.iter().filter(|entry| entry.sub != 0) {
            write!(
                text,
                "[[objects.subs]]\nsub_index = {}\nparameter_name = \"s{}\"\n{}",
                entry.sub,
                entry.sub,
                value(entry)
            )
            .unwrap();
        }
    }
    text
}

fn value(entry: &eds::Entry) -> String {
    let data_type = match entry.data_type {
        0x01 => "boolean".to_owned(),
        0x02 => "int8".into(),
        0x03 => "int16".into(),
        0x04 => "int32".into(),
        0x05 => "uint8".into(),
        0x06 => "uint16".into(),
        0x07 => "uint32".into(),
        0x09 => format!("visiblestring({})", entry.default.len().max(1)),
        _ => "domain".into(),
    };
    let mut text = format!("data_type = \"{data_type}\"\naccess_type = \"{}\"\n", entry.access);
    match entry.data_type {
        0x09 => text += &format!("default_value = \"{}\"\n", entry.default),
        0x0F => {}
        _ => text += &format!("default_value = {}\n", entry.number()),
    }
    if entry.mappable {
        text += "pdo_mapping = \"tpdo\"\n";
    }
    text
}
