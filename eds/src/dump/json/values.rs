//! The single values of a dump's file.
//!
//! Each is read inside its visitor: only there does serde_json know the value's place when it is refused.

use std::fmt;

use serde::de::{Deserialize, Deserializer, Error, Visitor};

use crate::ir::NodeId;

/// `5`: 1 to 127.
pub(super) struct Node(pub(super) NodeId);

impl<'de> Deserialize<'de> for Node {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_u64(NodeVisitor)
    }
}

struct NodeVisitor;

impl Visitor<'_> for NodeVisitor {
    type Value = Node;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a node-ID of 1 to 127")
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<Node, E> {
        let node_id = u8::try_from(number).ok().and_then(NodeId::new);
        node_id
            .map(Node)
            .ok_or_else(|| E::custom(format!("node {number} cannot be; a node-ID is 1 to 127")))
    }
}

/// A time as RFC 3339 writes it.
pub(super) struct Taken(pub(super) String);

impl<'de> Deserialize<'de> for Taken {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let read = |text: &str| looks_like_rfc3339(text).then(|| Self(text.to_owned()));
        deserializer.deserialize_str(TextVisitor {
            read,
            example: "a time as 2026-11-23T04:17:00Z",
        })
    }
}

/// Whether date, time and offset stand where RFC 3339 has them. Whether there is such a day is not asked: the time is
/// shown to people, nothing is computed from it.
fn looks_like_rfc3339(text: &str) -> bool {
    let fits = |text: &str, pattern: &str| {
        text.len() == pattern.len()
            && text
                .bytes()
                .zip(pattern.bytes())
                .all(|(c, p)| if p == b'0' { c.is_ascii_digit() } else { c == p })
    };
    let Some((stamp, rest)) = text.split_at_checked("0000-00-00T00:00:00".len()) else {
        return false;
    };
    let fraction = rest
        .strip_prefix('.')
        .map_or(0, |digits| 1 + digits.bytes().take_while(u8::is_ascii_digit).count());
    let offset = rest.get(fraction..).unwrap_or_default();
    fits(stamp, "0000-00-00T00:00:00")
        && fraction != 1
        && (offset == "Z" || fits(offset, "+00:00") || fits(offset, "-00:00"))
}

/// A number of 32 bits, written `"0x06090011"`.
pub(super) struct Number(pub(super) u32);

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_str(TextVisitor {
            read: read_number,
            example: "a number as \"0x06090011\"",
        })
    }
}

fn read_number(text: &str) -> Option<Number> {
    let digits = text.strip_prefix("0x")?;
    let is_hex = digits.bytes().all(|c| c.is_ascii_hexdigit());
    is_hex.then(|| u32::from_str_radix(digits, 16).ok().map(Number))?
}

/// Takes a string that `read` understands.
struct TextVisitor<F> {
    read: F,
    example: &'static str,
}

impl<T, F: FnOnce(&str) -> Option<T>> Visitor<'_> for TextVisitor<F> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.example)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<T, E> {
        (self.read)(text).ok_or_else(|| E::custom(format!("`{}` is not {}", shown(text), self.example)))
    }
}

/// The beginning of `text`, as much as a message has room for.
pub(super) fn shown(text: &str) -> String {
    let mut shown: String = text.chars().take(LONGEST_QUOTE).collect();
    if shown.len() < text.len() {
        shown.push('…');
    }
    shown
}

const LONGEST_QUOTE: usize = 40;
