//! A dump to text.

use std::fmt::{self, Write};

use super::{FORMAT, VERSION};
use crate::dump::{Answer, Dump, Identity};

impl Dump {
    /// The dump as JSON: one address a line, in the order of index and sub-index, ended by a line feed.
    ///
    /// The same dump gives the same text, and [`Dump::from_json`] gives the same dump.
    #[must_use]
    pub fn to_json(&self) -> String {
        let mut text = String::new();
        // Writing to a String cannot fail.
        let _ = write_dump(&mut text, self);
        text
    }
}

fn write_dump(out: &mut String, dump: &Dump) -> fmt::Result {
    writeln!(out, "{{")?;
    writeln!(out, "  \"format\": \"{FORMAT}\",")?;
    writeln!(out, "  \"version\": {VERSION},")?;
    writeln!(out, "  \"node\": {},", dump.node_id.get())?;
    if let Some(taken) = &dump.taken {
        writeln!(out, "  \"taken\": {},", serde_json::Value::from(taken.as_str()))?;
    }
    if let Some(device) = &dump.device {
        write_identity(out, device)?;
    }
    write_members(
        out,
        "objects",
        dump.objects
            .iter()
            .map(|(address, answer)| (address.to_string(), AsJson(answer).to_string())),
    )?;
    writeln!(out, "\n}}")
}

fn write_identity(out: &mut String, device: &Identity) -> fmt::Result {
    let facts = [
        ("device_type", device.device_type),
        ("vendor_id", device.vendor_id),
        ("product_code", device.product_code),
        ("revision_number", device.revision_number),
        ("serial_number", device.serial_number),
    ];
    let told = facts.into_iter().filter_map(|(name, fact)| Some((name, fact?)));
    write_members(
        out,
        "device",
        told.map(|(name, fact)| (name.to_owned(), format!("\"0x{fact:08X}\""))),
    )?;
    writeln!(out, ",")
}

/// An object of JSON, a member a line; without a line feed after its brace.
fn write_members(out: &mut String, name: &str, members: impl Iterator<Item = (String, String)>) -> fmt::Result {
    write!(out, "  \"{name}\": {{")?;
    let mut separator = "";
    for (key, value) in members {
        write!(out, "{separator}\n    \"{key}\": {value}")?;
        separator = ",";
    }
    out.write_str(if separator.is_empty() { "}" } else { "\n  }" })
}

struct AsJson<'a>(&'a Answer);

impl fmt::Display for AsJson<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Answer::Value(bytes) => write_bytes(f, bytes),
            Answer::Abort(code) => write!(f, "{{ \"abort\": \"0x{:08X}\" }}", code.0),
            Answer::Timeout => f.write_str("{ \"timeout\": true }"),
        }
    }
}

fn write_bytes(f: &mut fmt::Formatter<'_>, bytes: &[u8]) -> fmt::Result {
    f.write_char('"')?;
    for (place, byte) in bytes.iter().enumerate() {
        let gap = if place == 0 { "" } else { " " };
        write!(f, "{gap}{byte:02X}")?;
    }
    f.write_char('"')
}
