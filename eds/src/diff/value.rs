//! Values as a person reads them.

use crate::ir::{DataType, Value};

/// `value`, of `data_type`: numbers up to 16 bits in decimal, larger ones in hex, as a manual has them.
pub(super) fn shown(value: &Value, data_type: DataType) -> String {
    match value {
        Value::Boolean(value) => u8::from(*value).to_string(),
        Value::Integer(value) => value.to_string(),
        Value::Unsigned(value) if data_type.bits().is_some_and(|bits| bits <= 16) => value.to_string(),
        Value::Unsigned(value) => format!("0x{value:X}"),
        Value::NodeIdPlus(base) => format!("$NODEID+0x{base:X}"),
        Value::Real32(value) => format!("{value:?}"),
        Value::Real64(value) => format!("{value:?}"),
        Value::Text(text) => text.clone(),
        Value::Bytes(bytes) => bytes
            .iter()
            .fold(String::new(), |text, byte| format!("{text}{byte:02X}")),
        Value::Time { days, milliseconds } => format!("{days} {milliseconds}"),
    }
}
