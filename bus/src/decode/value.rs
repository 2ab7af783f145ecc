//! Values by their data type.

use lexican_eds::ir::{DataType, Value};

/// The value that `bits` are, the lowest `length` of a number, 1 to 64.
#[expect(
    clippy::cast_possible_wrap,
    clippy::cast_possible_truncation,
    reason = "two's complement is what goes on the bus"
)]
pub(super) fn of_bits(bits: u64, length: u8, data_type: Option<DataType>) -> Value {
    match data_type {
        Some(DataType::Boolean) => Value::Boolean(bits != 0),
        Some(DataType::Real32) if length == 32 => Value::Real32(f32::from_bits(bits as u32)),
        Some(DataType::Real64) if length == 64 => Value::Real64(f64::from_bits(bits)),
        Some(signed) if signed.is_signed() => {
            let unused = 64 - u32::from(length);
            Value::Integer((bits << unused) as i64 >> unused)
        }
        Some(number) if number.is_unsigned() => Value::Unsigned(bits),
        _ => {
            let bytes = bits.to_le_bytes();
            Value::Bytes(bytes.iter().copied().take(usize::from(length).div_ceil(8)).collect())
        }
    }
}

/// The value that an SDO transferred; its bytes where they are not as long as the type.
///
/// Of four bytes of which nobody said how many count those count that the type has.
pub(super) fn of_bytes(bytes: &[u8], is_sized: bool, data_type: Option<DataType>) -> Value {
    let bytes = counting(bytes, is_sized, data_type);
    data_type
        .and_then(|data_type| Value::from_bytes(bytes, data_type))
        .unwrap_or_else(|| Value::Bytes(bytes.to_vec()))
}

/// Those of `bytes` that count: where nobody said how many do, as many as the type has.
pub(super) fn counting(bytes: &[u8], is_sized: bool, data_type: Option<DataType>) -> &[u8] {
    let length = data_type.and_then(DataType::bytes).filter(|_| !is_sized);
    length.and_then(|length| bytes.get(..length)).unwrap_or(bytes)
}
