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
}
