//! The addresses of a dump's file and their answers.

use std::collections::BTreeMap;
use std::fmt;

use serde::de::{self, Deserialize, Deserializer, MapAccess, Visitor};

use super::values::{Number, shown};
use crate::dump::{AbortCode, Answer};
use crate::ir::Address;

/// Every address once.
pub(super) struct Objects(pub(super) BTreeMap<Address, Answer>);

impl<'de> Deserialize<'de> for Objects {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(ObjectsVisitor)
    }
}

struct ObjectsVisitor;

impl<'de> Visitor<'de> for ObjectsVisitor {
    type Value = Objects;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object of addresses and answers")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Objects, A::Error> {
        let mut objects = BTreeMap::new();
        while let Some(key) = map.next_key::<String>()? {
            let Some(address) = read_address(&key) else {
                return Err(de::Error::custom(format!(
                    "`{}` is not an address as 1018sub1",
                    shown(&key)
                )));
            };
            // Before the value is read: behind it, serde_json takes the next token's place for the error's.
            if objects.contains_key(&address) {
                return Err(de::Error::custom(format!("{address} has two answers")));
            }
            objects.insert(address, map.next_value()?);
        }
        Ok(Objects(objects))
    }
}

/// `1018sub1`: four hexadecimal digits of the index, one or two of the sub-index, in any case.
fn read_address(key: &str) -> Option<Address> {
    let (index, rest) = key.split_at_checked(4)?;
    let (word, sub) = rest.split_at_checked(3)?;
    let is_hex = |text: &str| text.bytes().all(|c| c.is_ascii_hexdigit());
    if !word.eq_ignore_ascii_case("sub") || sub.len() > 2 || !is_hex(index) || !is_hex(sub) {
        return None;
    }
    Some(Address::new(
        u16::from_str_radix(index, 16).ok()?,
        u8::from_str_radix(sub, 16).ok()?,
    ))
}

impl<'de> Deserialize<'de> for Answer {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(AnswerVisitor)
    }
}

struct AnswerVisitor;

impl<'de> Visitor<'de> for AnswerVisitor {
    type Value = Answer;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("bytes as \"92 01 02 00\", { \"abort\": \"0x06020000\" } or { \"timeout\": true }")
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Answer, E> {
        read_bytes(text)
            .map(Answer::Value)
            .ok_or_else(|| E::custom(format!("`{}` is not bytes as 92 01 02 00", shown(text))))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Answer, A::Error> {
        let answer = match map.next_key::<String>()?.as_deref() {
            Some("abort") => Answer::Abort(AbortCode(map.next_value::<Number>()?.0)),
            Some("timeout") if map.next_value()? => Answer::Timeout,
            _ => return Err(de::Error::invalid_value(de::Unexpected::Map, &self)),
        };
        match map.next_key::<String>()? {
            None => Ok(answer),
            Some(_) => Err(de::Error::custom("an address has one answer")),
        }
    }
}

/// Pairs of hexadecimal digits, in any case, with or without spaces between them.
fn read_bytes(text: &str) -> Option<Vec<u8>> {
    let words = text.split(' ').map(|word| word.as_bytes().chunks(2));
    words.flatten().map(read_byte).collect()
}

fn read_byte(pair: &[u8]) -> Option<u8> {
    let digit = |c: u8| char::from(c).to_digit(16);
    match *pair {
        [high, low] => u8::try_from(digit(high)? << 4 | digit(low)?).ok(),
        _ => None,
    }
}
