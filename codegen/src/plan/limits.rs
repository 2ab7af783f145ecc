//! LowLimit and HighLimit, where they say more than the type does.

use lexican_eds::ir::{DataType, Entry, Value};

use super::Kind;

/// The two limits of `entry` as the runtime compares them, low then high, each as wide as in the struct; `None` when
/// every value of the type is allowed, or none would be.
pub(crate) fn limits(entry: &Entry, kind: Kind) -> Option<Vec<u8>> {
    match kind {
        Kind::Boolean | Kind::Signed(_) | Kind::Unsigned(_) => integer_limits(entry, kind.size()),
        Kind::Real32 => real_limits(entry, f32_bytes),
        Kind::Real64 => real_limits(entry, f64_bytes),
        Kind::Time | Kind::Visible(_) | Kind::Octets(_) => None,
    }
}

fn integer_limits(entry: &Entry, width: usize) -> Option<Vec<u8>> {
    let (least, greatest) = range(entry.data_type);
    let within = |limit: Option<i128>, otherwise| limit.unwrap_or(otherwise).clamp(least, greatest);
    let low = within(entry.low.as_ref().and_then(integer), least);
    let high = within(entry.high.as_ref().and_then(integer), greatest);
    let says_something = low <= high && (low, high) != (least, greatest);
    says_something.then(|| {
        [low, high]
            .iter()
            .flat_map(|limit| limit.to_le_bytes().into_iter().take(width))
            .collect()
    })
}

/// The least and the greatest value of an integer type.
fn range(data_type: DataType) -> (i128, i128) {
    let bits = u32::from(data_type.bits().unwrap_or(64));
    if data_type.is_signed() {
        (-(1 << (bits - 1)), (1 << (bits - 1)) - 1)
    } else {
        (0, (1 << bits) - 1)
    }
}

/// The number of an integer value. A limit that follows the node-ID is none: no object has one that could.
fn integer(value: &Value) -> Option<i128> {
    match value {
        Value::Boolean(value) => Some(i128::from(*value)),
        Value::Integer(value) => Some(i128::from(*value)),
        Value::Unsigned(value) => Some(i128::from(*value)),
        _ => None,
    }
}

fn real_limits(entry: &Entry, bytes: impl Fn(f64) -> Vec<u8>) -> Option<Vec<u8>> {
    let low = entry.low.as_ref().and_then(real).unwrap_or(f64::NEG_INFINITY);
    let high = entry.high.as_ref().and_then(real).unwrap_or(f64::INFINITY);
    let says_something = low <= high && (low.is_finite() || high.is_finite());
    says_something.then(|| [bytes(low), bytes(high)].concat())
}

/// The number of a real value.
fn real(value: &Value) -> Option<f64> {
    match value {
        Value::Real32(value) => Some(f64::from(*value)),
        Value::Real64(value) => Some(*value),
        _ => None,
    }
    .filter(|value| !value.is_nan())
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "the limit of a REAL32 was read as a REAL32"
)]
fn f32_bytes(value: f64) -> Vec<u8> {
    (value as f32).to_le_bytes().to_vec()
}

fn f64_bytes(value: f64) -> Vec<u8> {
    value.to_le_bytes().to_vec()
}

#[cfg(test)]
mod tests {
    use lexican_eds::ir::{DataType, Value};

    use super::{Kind, limits};
    use crate::plan::test_entry;

    fn limits_of(data_type: DataType, low: Option<Value>, high: Option<Value>) -> Option<Vec<u8>> {
        let mut entry = test_entry(0x2000, 0, data_type);
        (entry.low, entry.high) = (low, high);
        limits(&entry, Kind::new(data_type, 0))
    }

    #[test]
    fn a_missing_limit_is_the_end_of_the_type() {
        let high = limits_of(DataType::Unsigned8, None, Some(Value::Unsigned(9)));
        assert_eq!(high, Some(vec![0, 9]));
        let low = limits_of(DataType::Integer24, Some(Value::Integer(-2)), None);
        assert_eq!(low, Some(vec![0xFE, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x7F, 0x00]));
    }

    #[test]
    fn the_whole_range_is_no_limit() {
        let all = limits_of(
            DataType::Unsigned16,
            Some(Value::Unsigned(0)),
            Some(Value::Unsigned(0xFFFF)),
        );
        assert_eq!(all, None);
        let all = limits_of(DataType::Unsigned64, None, Some(Value::Unsigned(u64::MAX)));
        assert_eq!(all, None);
        assert_eq!(limits_of(DataType::Real32, None, None), None);
    }

    #[test]
    fn limits_that_leave_no_value_are_not_enforced() {
        let inverted = limits_of(DataType::Unsigned8, Some(Value::Unsigned(9)), Some(Value::Unsigned(1)));
        assert_eq!(inverted, None);
    }

    #[test]
    fn a_real_without_a_high_limit_may_be_anything_above() {
        let low = limits_of(DataType::Real32, Some(Value::Real32(0.5)), None);
        assert_eq!(low, Some([0.5_f32.to_le_bytes(), f32::INFINITY.to_le_bytes()].concat()));
    }
}
