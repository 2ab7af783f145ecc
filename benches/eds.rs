//! As much of an EDS as the benches need: the values of a file that is known to be in order.

use std::collections::BTreeMap;

/// A value of the file.
pub struct Entry {
    pub index: u16,
    pub sub: u8,
    pub data_type: u8,
    pub access: String,
    pub mappable: bool,
    pub default: String,
}

impl Entry {
    /// The default as a number, with 0 for `$NODEID`.
    pub fn number(&self) -> i64 {
        let number = |text: &str| match text.trim().to_lowercase() {
            text if text.starts_with("0x") => i64::from_str_radix(&text[2..], 16).unwrap(),
            text if text == "$nodeid" || text.is_empty() => 0,
            text => text.parse().unwrap(),
        };
        self.default.split('+').map(number).sum()
    }
}

/// The values of `file`, by index and sub-index.
pub fn read(file: &str) -> Vec<Entry> {
    println!("cargo:rerun-if-changed={file}");
    let text = std::fs::read_to_string(file).unwrap_or_else(|error| panic!("{file}: {error}"));
    let mut sections: BTreeMap<String, BTreeMap<String, String>> = BTreeMap::new();
    let mut name = String::new();
    for line in text.lines().map(str::trim) {
        if let Some(header) = line.strip_prefix('[') {
            name = header.trim_end_matches(']').to_lowercase();
        } else if let Some((key, value)) = line.split_once('=') {
            sections
                .entry(name.clone())
                .or_default()
                .insert(key.into(), value.into());
        }
    }
    sections.iter().filter_map(|(name, keys)| entry(name, keys)).collect()
}

fn entry(name: &str, keys: &BTreeMap<String, String>) -> Option<Entry> {
    let (index, sub) = name.split_once("sub").unwrap_or((name, "0"));
    let text = |key: &str| keys.get(key).cloned().unwrap_or_default();
    Some(Entry {
        index: u16::from_str_radix(index, 16).ok()?,
        sub: u8::from_str_radix(sub, 16).ok()?,
        data_type: u8::from_str_radix(keys.get("DataType")?.trim_start_matches("0x"), 16).ok()?,
        access: text("AccessType"),
        mappable: text("PDOMapping") == "1",
        default: text("DefaultValue"),
    })
}
