//! REAL32 and REAL64.

use super::{Fault, Literal, Note, Notes, Radix, integer};

/// REAL32. A hex number is the bit pattern when it has all eight digits.
pub(super) fn real32(text: &str) -> Result<Literal<f32>, Fault> {
    if let Some(bits) = pattern(text, 8) {
        #[expect(clippy::cast_possible_truncation, reason = "a pattern of eight digits has 32 bits")]
        return Ok(as_bits(f32::from_bits(bits? as u32)));
    }
    decimal(text, f32::is_infinite)
}

/// REAL64. A hex number is the bit pattern when it has all sixteen digits.
pub(super) fn real64(text: &str) -> Result<Literal<f64>, Fault> {
    if let Some(bits) = pattern(text, 16) {
        return Ok(as_bits(f64::from_bits(bits?)));
    }
    decimal(text, f64::is_infinite)
}

const fn as_bits<T: Copy>(value: T) -> Literal<T> {
    let mut notes = Notes::NONE;
    notes.add(Note::RealAsBits);
    Literal { value, notes }
}

/// The bits of a hex number; `None` when it is not one. Zero is zero in any length.
fn pattern(text: &str, digits: u8) -> Option<Result<u64, Fault>> {
    let hex = integer(text).ok()?.value;
    (hex.radix == Radix::Hex).then(|| match hex.unsigned() {
        Some(bits) if hex.digits == digits || bits == 0 => Ok(bits),
        _ => Err(Fault::AmbiguousReal),
    })
}

fn decimal<T: std::str::FromStr + Copy>(text: &str, is_infinite: impl Fn(T) -> bool) -> Result<Literal<T>, Fault> {
    let (value, suffixed) = match text.parse::<T>() {
        Ok(value) => (value, false),
        Err(_) => (parse_suffixed(text)?, true),
    };
    // A number that overflows parses as infinite; only the word itself means it.
    if is_infinite(value) && text.bytes().any(|byte| byte.is_ascii_digit()) {
        return Err(Fault::OutOfRange);
    }
    let notes = if suffixed { Note::Suffix.into() } else { Notes::NONE };
    Ok(Literal { value, notes })
}

fn parse_suffixed<T: std::str::FromStr>(text: &str) -> Result<T, Fault> {
    let number = text.strip_suffix(['f', 'F']).ok_or(Fault::NotAReal)?;
    number.parse().map_err(|_| Fault::NotAReal)
}

#[cfg(test)]
mod tests {
    use super::{Fault, Note, real32, real64};

    #[test]
    fn a_real_is_decimal_text() {
        assert_eq!(real32("5.2").unwrap().value.to_bits(), 5.2_f32.to_bits());
        assert_eq!(real64("-10000000000").unwrap().value.to_bits(), (-1e10_f64).to_bits());
        assert_eq!(real32("1e-3").unwrap().value.to_bits(), 1e-3_f32.to_bits());
        assert_eq!(real32("010").unwrap().value.to_bits(), 10_f32.to_bits(), "not octal");
        assert!(real32("5.2").unwrap().notes.is_empty());
    }

    #[test]
    fn a_suffix_is_noted_and_left_out() {
        let literal = real32("0.5f").unwrap();
        assert_eq!(
            (literal.value.to_bits(), literal.notes),
            (0.5_f32.to_bits(), Note::Suffix.into())
        );
    }

    #[test]
    fn hex_with_all_digits_is_the_bit_pattern() {
        let one = real32("0x3F800000").unwrap();
        assert_eq!(
            (one.value.to_bits(), one.notes),
            (1_f32.to_bits(), Note::RealAsBits.into())
        );
        let pi = real64("0x400921FB54442D18").unwrap();
        assert_eq!(pi.value.to_bits(), std::f64::consts::PI.to_bits());
        assert_eq!(real32("0x0").unwrap().value.to_bits(), 0);
    }

    #[test]
    fn hex_of_another_length_could_mean_two_things_and_is_refused() {
        assert_eq!(real32("0x19999a"), Err(Fault::AmbiguousReal));
        assert_eq!(real32("-0x3F800000"), Err(Fault::AmbiguousReal));
        assert_eq!(real64("0x3F800000"), Err(Fault::AmbiguousReal));
    }

    #[test]
    fn what_the_type_cannot_hold_is_refused() {
        assert_eq!(real32("1e39"), Err(Fault::OutOfRange));
        assert!(real64("1e39").is_ok());
        assert!(real32("inf").unwrap().value.is_infinite());
        for text in ["", "abc", "1,5", "f", "1.0ff", "$NODEID"] {
            assert_eq!(real32(text), Err(Fault::NotAReal), "{text}");
        }
    }
}
