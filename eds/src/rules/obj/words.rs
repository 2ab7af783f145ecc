//! What rules about values say alike.

use crate::{ir::DataType, literal::Fault};

/// Data types from here on are the vendor's or a profile's (CiA 301, data types).
pub(super) const FIRST_OF_VENDORS: u16 = 0x40;

/// Why a text is no value of `data_type`, and what to write.
pub(super) fn unreadable(fault: Fault, data_type: DataType) -> (String, String) {
    let name = data_type.name();
    let (fact, cure) = match fault {
        Fault::OutOfRange => (format!("is out of the range of {name}"), range(data_type)),
        Fault::UnknownVariable => ("names a variable other than $NODEID".into(), "write `$NODEID`".into()),
        Fault::MisplacedFormula => (
            format!("is a formula, but the value is {name}"),
            "write a value without $NODEID".into(),
        ),
        Fault::AmbiguousReal => (
            format!("is hex, but has not all digits of {name}: is it a value, or are these bits?"),
            "write it in decimal, such as 1.5".into(),
        ),
        _ => (format!("cannot be read as {name}"), form(data_type)),
    };
    (fact, cure)
}

/// How to write a value.
fn form(data_type: DataType) -> String {
    match data_type {
        DataType::Boolean => "write 0 or 1",
        DataType::Real32 | DataType::Real64 => "write a decimal number, such as 1.5",
        DataType::OctetString | DataType::Domain => "write pairs of hex digits, such as 01FF",
        DataType::TimeOfDay | DataType::TimeDifference => "write days and milliseconds, such as `365 43200000`",
        _ => "write a number, such as 16 or 0x10",
    }
    .into()
}

fn range(data_type: DataType) -> String {
    let bits = u32::from(data_type.bits().unwrap_or(64));
    let (low, high) = if data_type.is_signed() {
        (-(1_i128 << (bits - 1)), (1_i128 << (bits - 1)) - 1)
    } else {
        (0, (1_i128 << bits) - 1)
    };
    format!("write a value from {low} to {high}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_is_that_of_the_type() {
        assert_eq!(range(DataType::Integer8), "write a value from -128 to 127");
        assert_eq!(
            range(DataType::Unsigned64),
            "write a value from 0 to 18446744073709551615"
        );
        assert_eq!(range(DataType::Boolean), "write a value from 0 to 1");
    }
}
