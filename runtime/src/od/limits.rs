//! Whether a number is within what its type and its object allow.

use super::{read, Access, DataType, Device, Entry, Table};
use crate::AbortCode;

/// `bits` as wide as they get: what is beyond the type's length becomes the sign of an INTEGER, zero of any other.
#[allow(clippy::cast_possible_wrap, clippy::cast_sign_loss)] // Two's complement, there and back.
pub(super) fn widen(data_type: DataType, bits: u64) -> u64 {
    let unused = 64usize.wrapping_sub(8 * data_type.length()) & 63;
    let bits = bits << unused;
    if data_type.is_signed() {
        (bits as i64 >> unused) as u64
    } else {
        bits >> unused
    }
}

/// Refuses a widened number that its type or its object's limits do not allow.
pub(super) fn check<D: Device>(device: &D, entry: Entry, bits: u64) -> Result<(), AbortCode> {
    if entry.data_type == DataType::BOOLEAN && bits > 1 {
        return Err(AbortCode::INVALID_VALUE);
    }
    if entry.access.has(Access::EXTRA) {
        return within(&device.table(), entry, bits);
    }
    Ok(())
}

/// Holds the number against its two limits.
fn within(table: &Table<'_>, entry: Entry, bits: u64) -> Result<(), AbortCode> {
    let (low, high) = limits(table, entry).ok_or(AbortCode::INTERNAL_INCOMPATIBILITY)?;
    let rank = |bits| rank(entry.data_type, widen(entry.data_type, bits));
    let value = rank(bits).ok_or(AbortCode::INVALID_VALUE)?;
    if Some(value) > rank(high) {
        return Err(AbortCode::VALUE_TOO_HIGH);
    }
    if Some(value) < rank(low) {
        return Err(AbortCode::VALUE_TOO_LOW);
    }
    Ok(())
}

/// Low and high limit.
fn limits(table: &Table<'_>, entry: Entry) -> Option<(u64, u64)> {
    let (_, at) = table.locate(entry)?;
    let width = entry.data_type.width();
    let limits = table.constants.get(at..)?;
    Some((
        read::bits(limits, width, true)?,
        read::bits(limits.get(width..)?, width, true)?,
    ))
}

/// A number that is greater when the value is: limits need no arithmetic of their own for each type, nor, on a small
/// target, floating point. `None` for a REAL that is no number.
#[allow(clippy::cast_possible_truncation)] // A REAL32 has 32 bits.
fn rank(data_type: DataType, bits: u64) -> Option<u64> {
    const SIGN: u64 = 1 << 63;
    match data_type {
        DataType::REAL32 => rank_real(u64::from(bits as u32) << 32, 0xFF << 55),
        DataType::REAL64 => rank_real(bits, 0x7FF << 52),
        _ if data_type.is_signed() => Some(bits ^ SIGN),
        _ => Some(bits),
    }
}

/// The rank of a floating point number with its sign in bit 63, its exponent at `exponent` and its fraction below.
fn rank_real(bits: u64, exponent: u64) -> Option<u64> {
    const SIGN: u64 = 1 << 63;
    let magnitude = bits & !SIGN;
    if magnitude > exponent {
        return None;
    }
    // Both zeros have the rank of the sign bit.
    Some(if bits & SIGN == 0 {
        SIGN + magnitude
    } else {
        SIGN - magnitude
    })
}

#[cfg(test)]
mod tests {
    use super::{rank, widen};
    use crate::od::DataType;

    #[test]
    fn ranks_order_reals_as_floating_point_does() {
        let values = [
            f64::NEG_INFINITY,
            -1e300,
            -1.5,
            -0.0,
            0.0,
            5e-324,
            1.0,
            1.5,
            f64::INFINITY,
        ];
        for (a, b) in values.into_iter().flat_map(|a| values.map(|b| (a, b))) {
            let [a_rank, b_rank] = [a, b].map(|x| rank(DataType::REAL64, x.to_bits()));
            assert_eq!(a_rank.cmp(&b_rank), a.partial_cmp(&b).unwrap());
        }
        assert_eq!(rank(DataType::REAL64, f64::NAN.to_bits()), None);

        let values = [f32::NEG_INFINITY, -1.5, -0.0, 0.0, 1e-45, 1.0, 1.5, f32::INFINITY];
        for (a, b) in values.into_iter().flat_map(|a| values.map(|b| (a, b))) {
            let [a_rank, b_rank] = [a, b].map(|x| rank(DataType::REAL32, u64::from(x.to_bits())));
            assert_eq!(a_rank.cmp(&b_rank), a.partial_cmp(&b).unwrap());
        }
        assert_eq!(rank(DataType::REAL32, u64::from(f32::NAN.to_bits())), None);
    }

    #[test]
    fn widening_keeps_the_sign_and_drops_what_is_beyond_the_length() {
        assert_eq!(widen(DataType::INTEGER24, 0xAAFF_FFFE), u64::MAX - 1);
        assert_eq!(widen(DataType::UNSIGNED24, 0xAAFF_FFFE), 0x00FF_FFFE);
        assert_eq!(widen(DataType::INTEGER64, 1 << 63), 1 << 63);
    }
}
