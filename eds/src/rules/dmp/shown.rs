//! Bytes as a person reads them.

use std::fmt::Write;

use crate::{
    ir::{DataType, Value},
    rules::quoted,
};

/// `bytes` as a value of `data_type`: `0x00000002` for unsigned, `-5` for signed, `"WDGA"` for texts; as bytes where they
/// are not as long as the type.
pub(super) fn shown(bytes: &[u8], data_type: DataType) -> String {
    match Value::from_bytes(bytes, data_type) {
        Some(Value::Unsigned(number)) => format!("0x{number:0width$X}", width = bytes.len() * 2),
        Some(Value::Integer(number)) => number.to_string(),
        Some(Value::Real32(number)) => format!("{number:?}"),
        Some(Value::Real64(number)) => format!("{number:?}"),
        Some(Value::Text(text)) => quoted(&visible(&text)),
        Some(Value::Time { days, milliseconds }) => format!("{days} d {milliseconds} ms"),
        Some(Value::Boolean(_) | Value::Bytes(_) | Value::NodeIdPlus(_)) | None => shown_bytes(bytes),
    }
}

/// `96 01 02 00`, cut when it would hide the message.
pub(super) fn shown_bytes(bytes: &[u8]) -> String {
    const LONGEST: usize = 16;
    let mut text = String::new();
    for byte in bytes.iter().take(LONGEST) {
        let _ = write!(text, "{byte:02X} ");
    }
    match bytes.len() {
        0 => "no bytes".into(),
        1..=LONGEST => text.trim_end().into(),
        length => format!("{text}… ({length} bytes)"),
    }
}

/// `text` with `\u{1b}` for what would act on a terminal.
fn visible(text: &str) -> String {
    let escape = |c: char| {
        if c.is_control() {
            c.escape_default().to_string()
        } else {
            c.to_string()
        }
    };
    text.chars().map(escape).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_are_shown_by_their_data_type() {
        let cases: [(&[u8], DataType, &str); 10] = [
            (&[2, 0, 0, 0], DataType::Unsigned32, "0x00000002"),
            (&[0xFB, 0xFF, 0xFF], DataType::Integer24, "-5"),
            (&[1], DataType::Boolean, "01"),
            (&[0, 0, 0x80, 0x3F], DataType::Real32, "1.0"),
            (b"WDGA\x1B[2J\0", DataType::VisibleString, "`WDGA\\u{1b}[2J\\u{0}`"),
            (
                &[0xFF; 20],
                DataType::OctetString,
                "FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF FF … (20 bytes)",
            ),
            (&[], DataType::Domain, "no bytes"),
            (&[], DataType::VisibleString, "``"),
            (&[5, 0], DataType::Unsigned32, "05 00"),
            (&[1, 0, 0, 0, 2, 0], DataType::TimeOfDay, "2 d 1 ms"),
        ];
        for (bytes, data_type, text) in cases {
            assert_eq!(shown(bytes, data_type), text);
        }
    }
}
