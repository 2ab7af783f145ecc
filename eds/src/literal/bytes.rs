//! Bytes in hex, and times.

use super::{Fault, Literal, Radix, integer};
use crate::ir::Value;

/// OCTET_STRING and DOMAIN: pairs of hex digits.
pub(super) fn bytes(text: &str) -> Result<Vec<u8>, Fault> {
    let text = text
        .strip_prefix("0x")
        .or_else(|| text.strip_prefix("0X"))
        .unwrap_or(text);
    let mut digits = text.bytes().filter(|byte| !byte.is_ascii_whitespace());
    let mut bytes = Vec::with_capacity(text.len() / 2);
    while let Some(high) = digits.next() {
        let low = digits.next().ok_or(Fault::NotBytes)?;
        bytes.push(nibble(high)? << 4 | nibble(low)?);
    }
    if bytes.is_empty() {
        Err(Fault::NotBytes)
    } else {
        Ok(bytes)
    }
}

fn nibble(digit: u8) -> Result<u8, Fault> {
    let value = char::from(digit).to_digit(16).ok_or(Fault::NotBytes)?;
    u8::try_from(value).map_err(|_| Fault::NotBytes)
}

/// TIME_OF_DAY and TIME_DIFFERENCE: `days milliseconds`, or the 48 bits as one number (CiA 301, 7.1.6.5: milliseconds in
/// the lower 28, days in the upper 16).
pub(super) fn time(text: &str) -> Result<Literal<Value>, Fault> {
    if let Some((days, milliseconds)) = text.split_once(char::is_whitespace) {
        return Ok(Literal::plain(of_parts(
            field(days)?,
            field(milliseconds.trim_start())?,
        )?));
    }
    let whole = integer(text).map_err(|_| Fault::NotATime)?;
    let bits = whole
        .value
        .unsigned()
        .filter(|&bits| bits < 1 << 48)
        .ok_or(Fault::OutOfRange)?;
    let value = of_parts(bits >> 32, bits & 0xFFFF_FFFF)?;
    Ok(whole.map(|_| value))
}

fn field(text: &str) -> Result<u64, Fault> {
    let integer = integer(text).map_err(|_| Fault::NotATime)?.value;
    match integer.radix {
        Radix::Octal => Err(Fault::NotATime),
        Radix::Decimal | Radix::Hex => integer.unsigned().ok_or(Fault::OutOfRange),
    }
}

fn of_parts(days: u64, milliseconds: u64) -> Result<Value, Fault> {
    Ok(Value::Time {
        days: u16::try_from(days).map_err(|_| Fault::OutOfRange)?,
        milliseconds: u32::try_from(milliseconds)
            .ok()
            .filter(|&milliseconds| milliseconds < 1 << 28)
            .ok_or(Fault::OutOfRange)?,
    })
}

#[cfg(test)]
mod tests {
    use super::{Fault, Value, bytes, time};

    #[test]
    fn bytes_are_pairs_of_hex_digits_with_or_without_blanks() {
        assert_eq!(bytes("ABcd"), Ok(vec![0xAB, 0xCD]));
        assert_eq!(bytes("00 01\t02"), Ok(vec![0, 1, 2]));
        assert_eq!(bytes("0x0001"), Ok(vec![0, 1]));
        for text in ["", "0", "@ABCD", "0x", "AB C", "äö"] {
            assert_eq!(bytes(text), Err(Fault::NotBytes), "{text}");
        }
    }

    #[test]
    fn a_time_is_days_and_milliseconds() {
        let noon = Value::Time {
            days: 365,
            milliseconds: 43_200_000,
        };
        assert_eq!(time("365 43200000").unwrap().value, noon);
        assert_eq!(time("0x016D02932E00").unwrap().value, noon);
        assert_eq!(time("noon"), Err(Fault::NotATime));
        assert_eq!(time("70000 0"), Err(Fault::OutOfRange));
        assert_eq!(time("1 0x10000000"), Err(Fault::OutOfRange));
        assert_eq!(time("0x1000000000000"), Err(Fault::OutOfRange));
    }
}
