//! Text to a dump.

use serde::de::IgnoredAny;

use super::objects::Objects;
use super::values::{Node, Number, Taken};
use super::{FORMAT, JsonError, VERSION};
use crate::dump::{Dump, Identity};

impl Dump {
    /// Reads what [`Dump::to_json`] wrote, or another tool that follows the format.
    ///
    /// # Errors
    /// The text is not UTF-8, not JSON, not a dump, of a newer version of the format, or has a value that cannot be: an
    /// address twice, a node-ID of 0, half a byte.
    pub fn from_json(text: &[u8]) -> Result<Self, JsonError> {
        let text = text.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(text);
        check_beginning(text)?;
        check_header(text)?;
        let file: File = serde_json::from_slice(text)?;
        Ok(Self {
            node_id: file.node.0,
            taken: file.taken.map(|taken| taken.0),
            device: file.device.map(Identity::from),
            objects: file.objects.0,
        })
    }
}

/// Refuses what cannot be a dump before a JSON reader says that it expected a value.
fn check_beginning(text: &[u8]) -> Result<(), JsonError> {
    let start = (1, 1);
    match text.iter().find(|byte| !byte.is_ascii_whitespace()) {
        Some(b'{') => Ok(()),
        None => Err(JsonError::new(start, "the dump is empty", "take the dump again")),
        Some(0xFF | 0xFE) => Err(JsonError::new(start, "the dump is not UTF-8 text", "save it as UTF-8")),
        Some(b'[' | b';') => Err(JsonError::new(
            start,
            "this looks like an EDS file, not a dump",
            "the EDS file comes first, then the dump",
        )),
        Some(_) => Err(JsonError::new(
            start,
            "this is not a dump: it does not begin with `{`",
            NAME_A_DUMP,
        )),
    }
}

/// Looks at `format` and `version` only, so that a newer dump is called newer, whatever else it holds.
fn check_header(text: &[u8]) -> Result<(), JsonError> {
    let header: Header = serde_json::from_slice(text)?;
    let Some((key, message, help)) = refusal(&header) else {
        return Ok(());
    };
    Err(JsonError::new(position_of(text, key), message, help))
}

/// The key to blame, what is wrong with it and the cure.
fn refusal(header: &Header) -> Option<(&'static str, String, &'static str)> {
    match (header.format.as_deref(), header.version) {
        (Some(FORMAT), Some(VERSION)) => None,
        (Some(FORMAT), Some(version)) if version > VERSION => Some((
            "\"version\"",
            format!("the dump is of version {version}; this program reads up to version {VERSION}"),
            "use a newer release of Lexican",
        )),
        (Some(FORMAT), Some(version)) => Some((
            "\"version\"",
            format!("there is no version {version} of the dump format"),
            "the oldest version is 1",
        )),
        (Some(FORMAT), None) => Some(("{", "the dump has no \"version\"".into(), "add \"version\": 1")),
        (Some(_), _) => Some(("\"format\"", "this JSON is of another format".into(), NAME_A_DUMP)),
        (None, _) => Some((
            "{",
            format!("this JSON is not a dump: it has no \"format\": \"{FORMAT}\""),
            NAME_A_DUMP,
        )),
    }
}

const NAME_A_DUMP: &str = "name a dump, as docs/dump-format.md describes it";

/// Line and column, from 1, of the first `key`.
fn position_of(text: &[u8], key: &str) -> (usize, usize) {
    let found = text.windows(key.len()).position(|window| window == key.as_bytes());
    let before = text.get(..found.unwrap_or(0)).unwrap_or_default();
    let mut lines = before.split(|&byte| byte == b'\n').rev();
    let column = lines.next().map_or(0, <[u8]>::len);
    (lines.count() + 1, column + 1)
}

#[derive(serde::Deserialize)]
struct Header {
    format: Option<String>,
    version: Option<u64>,
}

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields, rename = "dump")]
struct File {
    #[serde(rename = "format")]
    _format: IgnoredAny,
    #[serde(rename = "version")]
    _version: IgnoredAny,
    node: Node,
    taken: Option<Taken>,
    device: Option<Device>,
    objects: Objects,
}

#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields, rename = "device")]
#[expect(clippy::struct_field_names, reason = "the standard's names")]
struct Device {
    device_type: Option<Number>,
    vendor_id: Option<Number>,
    product_code: Option<Number>,
    revision_number: Option<Number>,
    serial_number: Option<Number>,
}

impl From<Device> for Identity {
    fn from(device: Device) -> Self {
        let number = |number: Option<Number>| number.map(|number| number.0);
        Self {
            device_type: number(device.device_type),
            vendor_id: number(device.vendor_id),
            product_code: number(device.product_code),
            revision_number: number(device.revision_number),
            serial_number: number(device.serial_number),
        }
    }
}
