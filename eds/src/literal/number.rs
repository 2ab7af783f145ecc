//! Integers and `$NODEID` formulas.

use super::{Fault, Literal, Note, Notes};

/// The base in which a number is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Radix {
    /// `16`
    Decimal,
    /// `0x10`
    Hex,
    /// `020`
    Octal,
}

/// An integer as it is written, of no type yet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Integer {
    /// Whether a `-` stands before it.
    pub negative: bool,
    /// The number without its sign.
    pub magnitude: u64,
    /// The base.
    pub radix: Radix,
    /// How many digits it has, leading zeros included; stops at 255.
    pub digits: u8,
}

impl Integer {
    /// The value; `None` when it does not fit.
    #[must_use]
    pub fn signed(self) -> Option<i64> {
        let magnitude = i128::from(self.magnitude);
        i64::try_from(if self.negative { -magnitude } else { magnitude }).ok()
    }

    /// The value; `None` when it is negative.
    #[must_use]
    pub const fn unsigned(self) -> Option<u64> {
        match self {
            Self { magnitude: 0, .. } => Some(0),
            Self { negative: true, .. } => None,
            Self { magnitude, .. } => Some(magnitude),
        }
    }
}

/// An integer or a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// `0x80`
    Plain(Integer),
    /// `$NODEID+0x80`, in any order.
    NodeIdPlus(Integer),
}

/// Reads an integer or a `$NODEID` formula (CiA 306-1, 4.6.2).
///
/// # Errors
///
/// [`Fault::NotANumber`], [`Fault::NotOctal`], [`Fault::UnknownVariable`], and [`Fault::OutOfRange`] beyond 64 bits.
pub fn number(text: &str) -> Result<Literal<Number>, Fault> {
    match integer(text) {
        Ok(literal) => Ok(literal.map(Number::Plain)),
        Err(Fault::NotANumber) => formula(text),
        Err(fault) => Err(fault),
    }
}

/// Reads an integer.
///
/// # Errors
///
/// [`Fault::NotANumber`], [`Fault::NotOctal`], and [`Fault::OutOfRange`] beyond 64 bits.
pub fn integer(text: &str) -> Result<Literal<Integer>, Fault> {
    let bytes = text.as_bytes();
    let (negative, bytes) = match bytes {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        _ => (false, bytes),
    };
    let (radix, bytes) = radix(bytes);
    let (digits, suffixed) = without_suffix(bytes);
    let magnitude = accumulate(digits, radix)?;
    Ok(Literal {
        value: Integer {
            negative,
            magnitude,
            radix,
            digits: u8::try_from(digits.len()).unwrap_or(u8::MAX),
        },
        notes: notes(digits, radix, magnitude, suffixed),
    })
}

const fn radix(bytes: &[u8]) -> (Radix, &[u8]) {
    match bytes {
        [b'0', b'x' | b'X', digits @ ..] => (Radix::Hex, digits),
        [b'0', digits @ ..] if !digits.is_empty() => (Radix::Octal, digits),
        _ => (Radix::Decimal, bytes),
    }
}

/// Cuts off `U`, `L`, `LL`, `ULL` …; none of those letters is a digit in any base.
fn without_suffix(bytes: &[u8]) -> (&[u8], bool) {
    let is_suffix = |byte: &u8| matches!(byte, b'u' | b'U' | b'l' | b'L');
    let len = bytes
        .iter()
        .rposition(|byte| !is_suffix(byte))
        .map_or(0, |last| last + 1);
    let (digits, suffix) = bytes.split_at(len);
    (digits, !suffix.is_empty())
}

fn accumulate(digits: &[u8], radix: Radix) -> Result<u64, Fault> {
    if digits.is_empty() {
        // `0L`: the 0 was taken for the mark of an octal number.
        return if matches!(radix, Radix::Octal) {
            Ok(0)
        } else {
            Err(Fault::NotANumber)
        };
    }
    let (base, not_a_digit) = match radix {
        Radix::Decimal => (10, Fault::NotANumber),
        Radix::Hex => (16, Fault::NotANumber),
        Radix::Octal => (8, Fault::NotOctal),
    };
    let mut magnitude: u64 = 0;
    let mut overflow = false;
    for &byte in digits {
        let digit = char::from(byte).to_digit(base).ok_or(match byte {
            b'8' | b'9' => not_a_digit,
            _ => Fault::NotANumber,
        })?;
        // Goes on after an overflow: a text that is no number shall be called that, not too large.
        match magnitude
            .checked_mul(u64::from(base))
            .and_then(|high| high.checked_add(u64::from(digit)))
        {
            Some(next) => magnitude = next,
            None => overflow = true,
        }
    }
    if overflow {
        Err(Fault::OutOfRange)
    } else {
        Ok(magnitude)
    }
}

fn notes(digits: &[u8], radix: Radix, magnitude: u64, suffixed: bool) -> Notes {
    let mut notes = Notes::NONE;
    if suffixed {
        notes.add(Note::Suffix);
    }
    if radix == Radix::Octal && accumulate(digits, Radix::Decimal) != Ok(magnitude) {
        notes.add(Note::Octal);
    }
    notes
}

fn formula(text: &str) -> Result<Literal<Number>, Fault> {
    const ZERO: Integer = Integer {
        negative: false,
        magnitude: 0,
        radix: Radix::Decimal,
        digits: 1,
    };
    let Some((left, right)) = text.split_once('+') else {
        return Ok(variable(text)?.map(|()| Number::NodeIdPlus(ZERO)));
    };
    let (left, right) = (left.trim_end(), right.trim_start());
    let (variable, base) = match integer(left) {
        Ok(base) => (variable(right)?, base),
        Err(_) => (variable(left)?, integer(right)?),
    };
    Ok(Literal {
        value: Number::NodeIdPlus(base.value),
        notes: base.notes.and(variable.notes),
    })
}

/// `$NODEID`, however it is spelled.
fn variable(text: &str) -> Result<Literal<()>, Fault> {
    let (dollar, name) = match text.strip_prefix('$') {
        Some(name) => (true, name.trim_start()),
        None => (false, text),
    };
    if !name.eq_ignore_ascii_case("NODEID") {
        return Err(if dollar {
            Fault::UnknownVariable
        } else {
            Fault::NotANumber
        });
    }
    let mut notes = Notes::NONE;
    if !dollar {
        notes.add(Note::NodeIdWithoutDollar);
    }
    if name != "NODEID" {
        notes.add(Note::NodeIdCase);
    }
    Ok(Literal { value: (), notes })
}

#[cfg(test)]
mod tests {
    use super::{Fault, Integer, Note, Notes, Number, Radix, integer, number};

    fn signed(text: &str) -> i64 {
        integer(text).unwrap().value.signed().unwrap()
    }

    fn base(text: &str) -> (u64, Notes) {
        let literal = number(text).unwrap();
        match literal.value {
            Number::NodeIdPlus(base) => (base.magnitude, literal.notes),
            Number::Plain(_) => panic!("{text} is no formula"),
        }
    }

    #[test]
    fn an_integer_may_be_decimal_hex_octal_and_negative() {
        assert_eq!(signed("0"), 0);
        assert_eq!(signed("1234"), 1234);
        assert_eq!(signed("+5"), 5);
        assert_eq!(signed("-128"), -128);
        assert_eq!(signed("0x1aF"), 0x1AF);
        assert_eq!(signed("0XFF"), 0xFF);
        assert_eq!(signed("-0x7f"), -0x7F);
        assert_eq!(signed("017"), 0o17);
        assert_eq!(signed("00"), 0);
        assert_eq!(integer("0xFFFFFFFFFFFFFFFF").unwrap().value.unsigned(), Some(u64::MAX));
    }

    #[test]
    fn a_leading_zero_is_noted_where_it_changes_the_value() {
        assert_eq!(integer("010").unwrap().notes, Note::Octal.into());
        assert!(integer("01").unwrap().notes.is_empty());
        assert_eq!(integer("08"), Err(Fault::NotOctal));
        assert_eq!(integer("0a"), Err(Fault::NotANumber));
    }

    #[test]
    fn a_suffix_of_c_is_noted_and_left_out() {
        let literal = integer("0x1234567890ABCDEFLL").unwrap();
        assert_eq!(literal.value.magnitude, 0x1234_5678_90AB_CDEF);
        assert_eq!(literal.notes, Note::Suffix.into());
        assert_eq!(signed("0UL"), 0);
        assert_eq!(integer("LL"), Err(Fault::NotANumber));
    }

    #[test]
    fn the_digits_are_counted_with_leading_zeros() {
        let Integer { radix, digits, .. } = integer("0x00000001").unwrap().value;
        assert_eq!((radix, digits), (Radix::Hex, 8));
        assert_eq!(integer(&format!("0x{}", "0".repeat(300))).unwrap().value.digits, 255);
    }

    #[test]
    fn what_is_no_integer_is_refused() {
        for text in ["", "-", "0x", "0x-3", "1.5", "12h", "No", "1 2", "é", "--1", "0x1G"] {
            assert_eq!(integer(text), Err(Fault::NotANumber), "{text}");
        }
        assert_eq!(integer("0x10000000000000000"), Err(Fault::OutOfRange));
        assert_eq!(integer("99999999999999999999"), Err(Fault::OutOfRange));
        assert_eq!(integer("99999999999999999999?"), Err(Fault::NotANumber));
    }

    #[test]
    fn a_formula_may_stand_in_every_order_and_spacing() {
        for text in [
            "$NODEID+0x80",
            "0x80+$NODEID",
            "$NODEID + 128",
            "0x80 + $NODEID",
            "$NODEID +0200",
        ] {
            assert_eq!(base(text).0, 0x80, "{text}");
        }
        assert!(base("$NODEID+0x80").1.is_empty());
        assert_eq!(base("$NODEID"), (0, Notes::NONE));
    }

    #[test]
    fn the_spelling_of_the_node_id_is_noted() {
        assert_eq!(base("$NodeId+0x600"), (0x600, Note::NodeIdCase.into()));
        assert_eq!(base("0x180+NODEID"), (0x180, Note::NodeIdWithoutDollar.into()));
        let both = Notes::from(Note::NodeIdCase).and(Note::NodeIdWithoutDollar.into());
        assert_eq!(base("0x180+NodeID"), (0x180, both));
    }

    #[test]
    fn a_formula_of_anything_else_is_refused() {
        assert_eq!(number("$MY_NODE_ID+0x200"), Err(Fault::UnknownVariable));
        assert_eq!(number("0x200+$NODE"), Err(Fault::UnknownVariable));
        for text in [
            "$NODEID+",
            "$NODEID+$NODEID",
            "\\+384",
            "+",
            "NodeID1",
            "1+2",
            "$NODEID+0x80+1",
        ] {
            assert!(number(text).is_err(), "{text}");
        }
    }
}
