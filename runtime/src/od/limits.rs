//! Whether a number is within what its type and its object allow.

use super::{read, Access, DataType, Device, Entry, NumberSet};
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

/// `bits` as they stand in the dictionary of `D`: its lowest [`DataType::width`] bytes.
pub(super) fn stored<D: Device>(data_type: DataType, bits: u64) -> u64 {
    if D::NUMBERS.has(NumberSet::WIDENED) {
        return widen(data_type, bits);
    }
    bits & (u64::MAX >> (64usize.wrapping_sub(8 * data_type.length()) & 63))
}

/// Refuses a number, as it stands in the dictionary, that its type or its object's limits do not allow.
pub(super) fn check<D: Device>(device: &D, entry: Entry, bits: u64) -> Result<(), AbortCode> {
    let [lowest, ..] = bits.to_le_bytes();
    if entry.data_type == DataType::BOOLEAN && lowest > 1 {
        return Err(AbortCode::INVALID_VALUE);
    }
    if D::NUMBERS.has(NumberSet::LIMITED) && entry.access.has(Access::EXTRA) {
        return within(device, entry, bits);
    }
    Ok(())
}

/// Holds the number against its two limits.
#[inline(never)] // Most numbers have none.
fn within<D: Device>(device: &D, entry: Entry, bits: u64) -> Result<(), AbortCode> {
    let value = rank(D::NUMBERS, entry.data_type, bits).ok_or(AbortCode::INVALID_VALUE)?;
    let [low, high] = limits(device, entry).ok_or(AbortCode::INTERNAL_INCOMPATIBILITY)?;
    if Some(value) > high {
        return Err(AbortCode::VALUE_TOO_HIGH);
    }
    if Some(value) < low {
        return Err(AbortCode::VALUE_TOO_LOW);
    }
    Ok(())
}

/// The ranks of low and high limit.
fn limits<D: Device>(device: &D, entry: Entry) -> Option<[Option<u64>; 2]> {
    let table = device.table();
    let (_, at) = table.locate(entry)?;
    let width = entry.data_type.width();
    let limit = |at: usize| {
        let bits = read::bits::<D>(table.constants.get(at..)?, width, true)?;
        rank(D::NUMBERS, entry.data_type, bits)
    };
    Some([limit(at), limit(at + width)])
}

/// A number that is greater when the value is: limits need no arithmetic of their own for each type, nor, on a small
/// target, floating point. `None` for a REAL that is no number.
#[inline(never)] // One copy for the value and both limits.
#[allow(clippy::cast_possible_truncation)] // A REAL32 has 32 bits.
fn rank(numbers: NumberSet, data_type: DataType, bits: u64) -> Option<u64> {
    if numbers.has(NumberSet::REAL) {
        match data_type {
            DataType::REAL32 => return rank_real(u64::from(bits as u32) << 32, 0xFF << 55),
            DataType::REAL64 => return rank_real(bits, 0x7FF << 52),
            _ => {}
        }
    }
    let sign = u64::from(data_type.is_signed()) << 63;
    Some(widen(data_type, bits) ^ sign)
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
    use crate::od::{DataType, NumberSet};

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
            let [a_rank, b_rank] = [a, b].map(|x| rank(NumberSet::ALL, DataType::REAL64, x.to_bits()));
            assert_eq!(a_rank.cmp(&b_rank), a.partial_cmp(&b).unwrap());
        }
        assert_eq!(rank(NumberSet::ALL, DataType::REAL64, f64::NAN.to_bits()), None);

        let values = [f32::NEG_INFINITY, -1.5, -0.0, 0.0, 1e-45, 1.0, 1.5, f32::INFINITY];
        for (a, b) in values.into_iter().flat_map(|a| values.map(|b| (a, b))) {
            let [a_rank, b_rank] = [a, b].map(|x| rank(NumberSet::ALL, DataType::REAL32, u64::from(x.to_bits())));
            assert_eq!(a_rank.cmp(&b_rank), a.partial_cmp(&b).unwrap());
        }
        assert_eq!(
            rank(NumberSet::ALL, DataType::REAL32, u64::from(f32::NAN.to_bits())),
            None
        );
    }

    #[test]
    fn widening_keeps_the_sign_and_drops_what_is_beyond_the_length() {
        assert_eq!(widen(DataType::INTEGER24, 0xAAFF_FFFE), u64::MAX - 1);
        assert_eq!(widen(DataType::UNSIGNED24, 0xAAFF_FFFE), 0x00FF_FFFE);
        assert_eq!(widen(DataType::INTEGER64, 1 << 63), 1 << 63);
    }
}
