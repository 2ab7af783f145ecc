//! A value of an object.

use super::{DataType, NodeId};

/// A value, of the data type that its entry names.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// BOOLEAN
    Boolean(bool),
    /// INTEGER8 to INTEGER64, within the type's range.
    Integer(i64),
    /// UNSIGNED8 to UNSIGNED64, within the type's range.
    Unsigned(u64),
    /// `$NODEID + n` of an integer type (CiA 306-1, 4.6.2); the sum wraps within the type's length.
    NodeIdPlus(u64),
    /// REAL32
    Real32(f32),
    /// REAL64
    Real64(f64),
    /// VISIBLE_STRING, UNICODE_STRING: the text as decoded from the file.
    Text(String),
    /// OCTET_STRING, DOMAIN: the bytes.
    Bytes(Vec<u8>),
    /// TIME_OF_DAY, TIME_DIFFERENCE
    Time {
        /// Days (since 1 January 1984 for TIME_OF_DAY).
        days: u16,
        /// Milliseconds, 28 bits.
        milliseconds: u32,
    },
}

impl Value {
    /// The bytes as an SDO transfers them: little-endian, as long as `data_type` is.
    ///
    /// `node_id` resolves a formula; without it `$NODEID` counts as 0. A VISIBLE_STRING keeps one byte a character where
    /// the character is in ISO 8859-1, else UTF-8.
    #[must_use]
    pub fn to_bytes(&self, data_type: DataType, node_id: Option<NodeId>) -> Vec<u8> {
        let number = |bits: u64| bits.to_le_bytes()[..data_type.bytes().unwrap_or(8)].to_vec();
        match self {
            Self::Boolean(value) => vec![u8::from(*value)],
            #[expect(clippy::cast_sign_loss, reason = "two's complement is what goes on the bus")]
            Self::Integer(value) => number(*value as u64),
            Self::Unsigned(value) => number(*value),
            Self::NodeIdPlus(base) => number(base.wrapping_add(node_id.map_or(0, |id| u64::from(id.get())))),
            Self::Real32(value) => value.to_le_bytes().to_vec(),
            Self::Real64(value) => value.to_le_bytes().to_vec(),
            Self::Text(text) if data_type == DataType::UnicodeString => {
                text.encode_utf16().flat_map(u16::to_le_bytes).collect()
            }
            Self::Text(text) => {
                let latin1: Option<Vec<u8>> = text.chars().map(|c| u8::try_from(c).ok()).collect();
                latin1.unwrap_or_else(|| text.as_bytes().to_vec())
            }
            Self::Bytes(bytes) => bytes.clone(),
            Self::Time { days, milliseconds } => {
                let mut bytes = (milliseconds & 0x0FFF_FFFF).to_le_bytes().to_vec();
                bytes.extend(days.to_le_bytes());
                bytes
            }
        }
    }

    /// The value that `bytes` are, as an SDO transferred them; `None` when they are not as long as `data_type` is.
    ///
    /// A VISIBLE_STRING is read as UTF-8 where it is that, else as ISO 8859-1. Any byte but 0 is a true BOOLEAN.
    #[must_use]
    pub fn from_bytes(bytes: &[u8], data_type: DataType) -> Option<Self> {
        if data_type.bytes().is_some_and(|length| length != bytes.len()) {
            return None;
        }
        Some(match data_type {
            DataType::Boolean => Self::Boolean(bytes != [0]),
            DataType::Real32 => Self::Real32(f32::from_le_bytes(bytes.try_into().ok()?)),
            DataType::Real64 => Self::Real64(f64::from_le_bytes(bytes.try_into().ok()?)),
            DataType::VisibleString => Self::Text(visible_text(bytes)),
            DataType::UnicodeString => Self::Text(unicode_text(bytes)?),
            DataType::OctetString | DataType::Domain => Self::Bytes(bytes.to_vec()),
            DataType::TimeOfDay | DataType::TimeDifference => {
                let (milliseconds, days) = bytes.split_at_checked(4)?;
                let milliseconds = u32::from_le_bytes(milliseconds.try_into().ok()?) & 0x0FFF_FFFF;
                let days = u16::from_le_bytes(days.try_into().ok()?);
                Self::Time { days, milliseconds }
            }
            signed if signed.is_signed() => Self::Integer(signed_number(bytes)),
            _ => Self::Unsigned(unsigned_number(bytes)),
        })
    }
}

fn unsigned_number(bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .rev()
        .fold(0, |number, &byte| number << 8 | u64::from(byte))
}

fn signed_number(bytes: &[u8]) -> i64 {
    let sign = bytes.last().map_or(0, |&high| if high & 0x80 == 0 { 0 } else { -1 });
    bytes
        .iter()
        .rev()
        .fold(sign, |number, &byte| number << 8 | i64::from(byte))
}

fn visible_text(bytes: &[u8]) -> String {
    let latin1 = || bytes.iter().map(|&byte| char::from(byte)).collect();
    str::from_utf8(bytes).map_or_else(|_| latin1(), str::to_owned)
}

/// UTF-16, little-endian; half a pair becomes U+FFFD. `None` for half a code unit.
fn unicode_text(bytes: &[u8]) -> Option<String> {
    let unit = |pair: &[u8]| Some(u16::from_le_bytes(pair.try_into().ok()?));
    let units: Vec<u16> = bytes.chunks(2).map(unit).collect::<Option<_>>()?;
    Some(String::from_utf16_lossy(&units))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_the_same_after_the_bus() {
        let cases = [
            (Value::Integer(-2), DataType::Integer24, vec![0xFE, 0xFF, 0xFF]),
            (
                Value::Integer(i64::MIN),
                DataType::Integer64,
                vec![0, 0, 0, 0, 0, 0, 0, 0x80],
            ),
            (
                Value::Integer(0x007F_FFFF_FFFF),
                DataType::Integer40,
                vec![0xFF, 0xFF, 0xFF, 0xFF, 0x7F],
            ),
            (Value::Unsigned(u64::MAX), DataType::Unsigned64, vec![0xFF; 8]),
            (
                Value::Unsigned(0x0102_0304_0506),
                DataType::Unsigned48,
                vec![6, 5, 4, 3, 2, 1],
            ),
            (Value::Boolean(true), DataType::Boolean, vec![1]),
            (Value::Real32(-1.5), DataType::Real32, vec![0, 0, 0xC0, 0xBF]),
            (
                Value::Text("Größe".into()),
                DataType::VisibleString,
                b"Gr\xF6\xDFe".to_vec(),
            ),
            (Value::Text("ω".into()), DataType::UnicodeString, vec![0xC9, 0x03]),
            (
                Value::Time {
                    days: 1,
                    milliseconds: 2,
                },
                DataType::TimeOfDay,
                vec![2, 0, 0, 0, 1, 0],
            ),
        ];
        for (value, data_type, bytes) in cases {
            assert_eq!(value.to_bytes(data_type, None), bytes);
            assert_eq!(Value::from_bytes(&bytes, data_type), Some(value));
        }
    }

    #[test]
    fn bytes_of_another_length_are_no_value() {
        for data_type in [
            DataType::Unsigned24,
            DataType::Real32,
            DataType::TimeOfDay,
            DataType::UnicodeString,
        ] {
            assert_eq!(Value::from_bytes(&[1], data_type), None);
            assert_eq!(Value::from_bytes(&[0; 9], data_type), None);
        }
    }
}
