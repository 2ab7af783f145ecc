//! A value of a data type.

use super::{Fault, Integer, Literal, Note, Notes, Number, Radix, bytes, integer, number, real, without_comment};
use crate::ir::{DataType, Value};

/// Reads a value of `data_type`.
///
/// # Errors
///
/// Why `text` is no value of that type.
pub fn value(text: &str, data_type: DataType) -> Result<Literal<Value>, Fault> {
    match data_type {
        DataType::VisibleString | DataType::UnicodeString => {
            Ok(self::text(text).map(|text| Value::Text(text.to_owned())))
        }
        _ => without_comment(text, |text| typed(text, data_type)),
    }
}

/// Reads a text: as it is written, without a pair of double quotes around it.
///
/// The standard knows no quotes. Whoever writes `DefaultValue="JVL A/S"` means a device that answers `JVL A/S`.
#[must_use]
pub fn text(text: &str) -> Literal<&str> {
    let quoted = text.strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
    match quoted.filter(|inner| !inner.contains('"')) {
        Some(inner) => Literal {
            value: inner,
            notes: Note::Quoted.into(),
        },
        None => Literal::plain(text),
    }
}

/// Reads a number from 0 to `max`.
///
/// # Errors
///
/// Why `text` is no such number.
pub fn unsigned(text: &str, max: u64) -> Result<Literal<u64>, Fault> {
    without_comment(text, |text| {
        let literal = integer(text)?;
        let value = literal.value.unsigned().filter(|&value| value <= max);
        let value = value.ok_or(Fault::OutOfRange)?;
        Ok(literal.map(|_| value))
    })
}

fn typed(text: &str, data_type: DataType) -> Result<Literal<Value>, Fault> {
    match data_type {
        DataType::Real32 => real::real32(text)
            .map(|literal| literal.map(Value::Real32))
            .map_err(|fault| of_real(text, fault)),
        DataType::Real64 => real::real64(text)
            .map(|literal| literal.map(Value::Real64))
            .map_err(|fault| of_real(text, fault)),
        DataType::OctetString | DataType::Domain => bytes::bytes(text).map(Value::Bytes).map(Literal::plain),
        DataType::TimeOfDay | DataType::TimeDifference => bytes::time(text),
        _ => of_integer_type(text, data_type),
    }
}

/// A formula is a number, only not here.
fn of_real(text: &str, fault: Fault) -> Fault {
    match number(text) {
        Ok(Literal {
            value: Number::NodeIdPlus(_),
            ..
        }) => Fault::MisplacedFormula,
        _ => fault,
    }
}

fn of_integer_type(text: &str, data_type: DataType) -> Result<Literal<Value>, Fault> {
    let bits = data_type.bits().unwrap_or(64);
    let literal = number(text)?;
    let (value, notes) = match literal.value {
        Number::Plain(integer) => fit(integer, data_type, bits)?,
        Number::NodeIdPlus(_) if data_type == DataType::Boolean => return Err(Fault::MisplacedFormula),
        Number::NodeIdPlus(base) => (Value::NodeIdPlus(fit_unsigned(base, bits)?), wide(base, bits)),
    };
    Ok(Literal {
        value,
        notes: literal.notes.and(notes),
    })
}

fn fit(integer: Integer, data_type: DataType, bits: u8) -> Result<(Value, Notes), Fault> {
    if data_type.is_signed() {
        let (value, notes) = fit_signed(integer, bits)?;
        return Ok((Value::Integer(value), notes.and(wide(integer, bits))));
    }
    let value = fit_unsigned(integer, bits)?;
    let value = match data_type {
        DataType::Boolean => Value::Boolean(value != 0),
        _ => Value::Unsigned(value),
    };
    Ok((value, wide(integer, bits)))
}

fn fit_unsigned(integer: Integer, bits: u8) -> Result<u64, Fault> {
    let max = u64::MAX >> (64 - bits);
    integer
        .unsigned()
        .filter(|&value| value <= max)
        .ok_or(Fault::OutOfRange)
}

/// A hex number with the top bit of the type set is a two's complement. A decimal one is out of range.
fn fit_signed(integer: Integer, bits: u8) -> Result<(i64, Notes), Fault> {
    let half = 1_i64 << (bits - 2);
    let (min, max) = (-half - half, half - 1 + half);
    if let Some(value) = integer.signed().filter(|value| (min..=max).contains(value)) {
        return Ok((value, Notes::NONE));
    }
    if integer.radix != Radix::Hex || integer.negative {
        return Err(Fault::OutOfRange);
    }
    let unused = 64 - bits;
    let pattern = fit_unsigned(integer, bits)? << unused;
    Ok((pattern.cast_signed() >> unused, Note::TwosComplement.into()))
}

fn wide(integer: Integer, bits: u8) -> Notes {
    let digits = bits.div_ceil(8) * 2;
    if integer.radix == Radix::Hex && integer.digits > digits {
        Note::WideHex.into()
    } else {
        Notes::NONE
    }
}

#[cfg(test)]
mod tests {
    use super::{DataType, Fault, Note, Notes, Value, text, unsigned, value};

    fn read(text: &str, data_type: DataType) -> Value {
        value(text, data_type).unwrap().value
    }

    fn notes(text: &str, data_type: DataType) -> Notes {
        value(text, data_type).unwrap().notes
    }

    fn fault(text: &str, data_type: DataType) -> Fault {
        value(text, data_type).unwrap_err()
    }

    #[test]
    fn each_integer_type_holds_its_range_and_nothing_beyond() {
        for (data_type, min, max) in [
            (DataType::Integer8, i64::from(i8::MIN), i64::from(i8::MAX)),
            (DataType::Integer24, -0x80_0000, 0x7F_FFFF),
            (DataType::Integer56, -0x80_0000_0000_0000, 0x7F_FFFF_FFFF_FFFF),
            (DataType::Integer64, i64::MIN, i64::MAX),
        ] {
            assert_eq!(read(&min.to_string(), data_type), Value::Integer(min));
            assert_eq!(read(&max.to_string(), data_type), Value::Integer(max));
            assert_eq!(fault(&(i128::from(min) - 1).to_string(), data_type), Fault::OutOfRange);
            assert_eq!(fault(&(i128::from(max) + 1).to_string(), data_type), Fault::OutOfRange);
        }
        for (data_type, max) in [
            (DataType::Unsigned8, 0xFF),
            (DataType::Unsigned40, 0xFF_FFFF_FFFF),
            (DataType::Unsigned64, u64::MAX),
        ] {
            assert_eq!(read(&max.to_string(), data_type), Value::Unsigned(max));
            assert_eq!(fault(&(u128::from(max) + 1).to_string(), data_type), Fault::OutOfRange);
            assert_eq!(fault("-1", data_type), Fault::OutOfRange);
        }
    }

    #[test]
    fn hex_of_a_signed_type_is_twos_complement_and_noted() {
        assert_eq!(
            read("0x80000000", DataType::Integer32),
            Value::Integer(i64::from(i32::MIN))
        );
        assert_eq!(notes("0x80000000", DataType::Integer32), Note::TwosComplement.into());
        assert_eq!(read("0xFF", DataType::Integer8), Value::Integer(-1));
        assert_eq!(read("0xFFFFFF", DataType::Integer24), Value::Integer(-1));
        assert_eq!(read("0xFFFFFFFFFFFFFFFF", DataType::Integer64), Value::Integer(-1));
        assert_eq!(fault("0x1FF", DataType::Integer8), Fault::OutOfRange);
        assert_eq!(fault("255", DataType::Integer8), Fault::OutOfRange);
        assert_eq!(fault("-0xFF", DataType::Integer8), Fault::OutOfRange);
    }

    #[test]
    fn hex_with_more_digits_than_the_type_is_accepted_in_range_and_noted() {
        assert_eq!(read("0x00000005", DataType::Unsigned16), Value::Unsigned(5));
        assert_eq!(notes("0x00000005", DataType::Unsigned16), Note::WideHex.into());
        assert!(notes("0x0005", DataType::Unsigned16).is_empty());
        assert!(notes("0x01", DataType::Boolean).is_empty());
        assert_eq!(fault("65536", DataType::Unsigned16), Fault::OutOfRange);
    }

    #[test]
    fn a_boolean_is_0_or_1() {
        assert_eq!(read("1", DataType::Boolean), Value::Boolean(true));
        assert_eq!(read("0x0", DataType::Boolean), Value::Boolean(false));
        assert_eq!(fault("3", DataType::Boolean), Fault::OutOfRange);
    }

    #[test]
    fn a_formula_belongs_to_integers_alone() {
        assert_eq!(read("$NODEID+0x80", DataType::Unsigned32), Value::NodeIdPlus(0x80));
        assert_eq!(fault("$NODEID+0x100", DataType::Unsigned8), Fault::OutOfRange);
        assert_eq!(fault("$NODEID", DataType::Boolean), Fault::MisplacedFormula);
        assert_eq!(fault("$NODEID+1", DataType::Real32), Fault::MisplacedFormula);
        assert_eq!(read("$NODEID", DataType::VisibleString), Value::Text("$NODEID".into()));
    }

    #[test]
    fn a_comment_behind_a_number_is_noted_and_left_out() {
        assert_eq!(
            read("0x100     ; COB-ID 0x100", DataType::Unsigned32),
            Value::Unsigned(0x100)
        );
        assert_eq!(notes("5 # ms", DataType::Unsigned16), Note::TrailingComment.into());
        assert_eq!(read("5.0 # s", DataType::Real32), Value::Real32(5.0));
        assert_eq!(
            read("C# minor", DataType::VisibleString),
            Value::Text("C# minor".into())
        );
        assert_eq!(fault("# nothing", DataType::Unsigned8), Fault::NotANumber);
    }

    #[test]
    fn a_text_is_as_written_without_quotes_around_it() {
        assert_eq!(text("\"JVL A/S\"").value, "JVL A/S");
        assert_eq!(text("\"JVL A/S\"").notes, Note::Quoted.into());
        for same in ["JVL A/S", "\"", "5\" disk", "\"a\" and \"b\"", "0x0", "\\n"] {
            assert_eq!(text(same).value, same);
        }
    }

    #[test]
    fn a_number_of_a_keyword_has_its_own_range() {
        assert_eq!(unsigned("0x0B", 255).unwrap().value, 11);
        assert_eq!(unsigned("0x07 # VAR", 255).unwrap().notes, Note::TrailingComment.into());
        assert_eq!(unsigned("256", 255), Err(Fault::OutOfRange));
        assert_eq!(unsigned("-1", 255), Err(Fault::OutOfRange));
        assert_eq!(unsigned("", 255), Err(Fault::NotANumber));
    }
}
