//! How sharp validation is: a device is held against its file in which one statement was changed, again and again, and the
//! change is to be found and named.
//!
//! What reading a device cannot show is not among the changes: whether it may be written as well, a data type of the same
//! length, the errors of a history (1003h), of which there are none, and a serial number (1018h:04), which is one device's own.

use std::{fs, path::Path};

use lexican_eds::{
    diagnostic::Diagnostic,
    rules::{self, Levels},
    span::Span,
};
use lexican_tests::{bus::Bus, sdo_client, simulated::Simulated};

/// So many changes of each file.
const CHANGES: usize = 500;

/// Pseudo-random numbers, the same in every run (Marsaglia's xorshift).
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 >> 32).expect("32 bits") % bound
    }
}

/// A section of a file.
struct Section {
    /// `1018sub1`, `1017`, `DeviceInfo`.
    name: String,
    lines: Vec<String>,
}

impl Section {
    fn value(&self, keyword: &str) -> Option<&str> {
        self.lines
            .iter()
            .find_map(|line| line.strip_prefix(keyword)?.strip_prefix('='))
    }

    fn set(&mut self, keyword: &str, value: &str) {
        self.lines.retain(|line| !line.starts_with(&format!("{keyword}=")));
        self.lines.push(format!("{keyword}={value}"));
    }

    /// Whether it describes a number that has a value after power-on and can be read.
    fn is_number(&self) -> bool {
        !self.name.starts_with("1003")
            && self.name != "1018sub4"
            && matches!(self.value("DataType"), Some("0x0005" | "0x0006" | "0x0007"))
            && self.value("DefaultValue").is_some_and(|value| number(value).is_some())
            && matches!(self.value("AccessType"), Some("ro" | "rw" | "const"))
    }
}

fn number(text: &str) -> Option<u64> {
    match text.strip_prefix("0x") {
        Some(digits) => u64::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    }
}

/// The file, taken apart at its headers.
fn sections(text: &str) -> Vec<Section> {
    let mut sections: Vec<Section> = Vec::new();
    for line in text.lines() {
        match line.strip_prefix('[').and_then(|rest| rest.split(']').next()) {
            Some(name) => sections.push(Section {
                name: name.to_owned(),
                lines: Vec::new(),
            }),
            None => sections
                .last_mut()
                .expect("a header comes first")
                .lines
                .push(line.to_owned()),
        }
    }
    sections
}

fn text(sections: &[Section]) -> String {
    let parts = sections
        .iter()
        .map(|section| format!("[{}]\n{}\n", section.name, section.lines.join("\n")));
    parts.collect()
}

/// Changes one statement, and says what and where.
fn change(text: &str, numbers: &mut Numbers) -> (String, String, &'static str) {
    let mut all = sections(text);
    loop {
        let at = numbers.below(all.len());
        let Some(section) = all.get_mut(at).filter(|section| section.is_number()) else {
            continue;
        };
        let value = section.value("DefaultValue").and_then(number).expect("it is a number");
        let name = section.name.clone();
        let kind = match numbers.below(5) {
            0 => {
                section.set("DefaultValue", &(value ^ (1 << numbers.below(8))).to_string());
                "default"
            }
            1 => {
                let other = if section.value("DataType") == Some("0x0007") {
                    "0x0005"
                } else {
                    "0x0007"
                };
                section.set("DataType", other);
                "data type"
            }
            2 => {
                section.set("AccessType", "wo");
                "access"
            }
            3 => {
                section.set("LowLimit", &(value + 1).to_string());
                "limit"
            }
            _ => {
                all.remove(at);
                "object gone"
            }
        };
        return (self::text(&all), name, kind);
    }
}

/// The name of the section that a finding is in; nothing for one about the whole file.
fn section_at(file: &str, span: Span) -> &str {
    let before = file.get(..span.end as usize).unwrap_or_default();
    let header = before.rsplit("\n[").next().and_then(|rest| rest.split(']').next());
    header.unwrap_or_default()
}

/// What is found, each with the section that it is found in, when the device of `original` is held against `file`.
fn found(original: &str, file: &str) -> Vec<String> {
    let device = lexican_eds::read("device.eds", original.as_bytes().to_vec());
    let mut bus = Bus::booted(Simulated::of(&device.dictionary), 1);
    let dump = sdo_client::dump(&mut bus, device.dictionary.entries().map(|entry| entry.address));
    let reading = lexican_eds::read("device.eds", file.as_bytes().to_vec());
    let mut found = rules::validate(&reading, &dump, &Levels::default());
    // A file that contradicts itself is a matter of `check`; whoever validates has checked it.
    found.extend(rules::check(&reading, &Levels::default()));
    let told = |diagnostic: Diagnostic| format!("[{}] {}", section_at(file, diagnostic.span), diagnostic.message);
    found.into_iter().map(told).collect()
}

#[test]
fn every_one_of_a_thousand_changes_of_a_file_is_found_and_named() {
    for (file, seed) in [
        ("wdga.eds", 0x2545_F491_4F6C_DD1D),
        ("wv58mr.eds", 0x9E37_79B9_7F4A_7C15),
    ] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../eds/devices").join(file);
        let original = fs::read_to_string(path).expect("a file of the project");
        assert_eq!(found(&original, &original), [""; 0]);
        let mut numbers = Numbers(seed);
        let index = |name: &str| name.split("sub").next().unwrap_or_default().to_owned();
        let missed: Vec<String> = (0..CHANGES)
            .filter_map(|_| {
                let (changed, name, kind) = change(&original, &mut numbers);
                let messages = found(&original, &changed);
                let named = messages.iter().any(|message| message.contains(&index(&name)));
                (!named).then(|| format!("{file}: {kind} of {name}: {messages:?}"))
            })
            .collect();
        assert_eq!(missed, [""; 0]);
    }
}
