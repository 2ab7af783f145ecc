//! Why a device refused.

use std::fmt;

/// An SDO abort code (CiA 301, table 22). A device may send any number, hence a newtype with constants.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct AbortCode(pub u32);

impl AbortCode {
    /// 0504 0000h: SDO protocol timed out.
    pub const TIMED_OUT: Self = Self(0x0504_0000);
    /// 0601 0000h: unsupported access to an object.
    pub const UNSUPPORTED_ACCESS: Self = Self(0x0601_0000);
    /// 0601 0001h: attempt to read a write-only object.
    pub const WRITE_ONLY: Self = Self(0x0601_0001);
    /// 0602 0000h: object does not exist in the object dictionary.
    pub const NO_SUCH_OBJECT: Self = Self(0x0602_0000);
    /// 0609 0011h: sub-index does not exist.
    pub const NO_SUCH_SUB_INDEX: Self = Self(0x0609_0011);

    /// What the standard says of it; `None` for a code that it does not define.
    #[must_use]
    pub fn meaning(self) -> Option<&'static str> {
        let found = MEANINGS.binary_search_by_key(&self.0, |meaning| meaning.0).ok()?;
        MEANINGS.get(found).map(|meaning| meaning.1)
    }
}

impl fmt::Display for AbortCode {
    /// `0601 0001h (attempt to read a write-only object)`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:04X} {:04X}h", self.0 >> 16, self.0 & 0xFFFF)?;
        match self.meaning() {
            Some(meaning) => write!(f, " ({meaning})"),
            None => Ok(()),
        }
    }
}

const MEANINGS: [(u32, &str); 31] = [
    (0x0503_0000, "toggle bit not alternated"),
    (0x0504_0000, "SDO protocol timed out"),
    (0x0504_0001, "command specifier not valid or unknown"),
    (0x0504_0002, "invalid block size"),
    (0x0504_0003, "invalid sequence number"),
    (0x0504_0004, "CRC error"),
    (0x0504_0005, "out of memory"),
    (0x0601_0000, "unsupported access to an object"),
    (0x0601_0001, "attempt to read a write-only object"),
    (0x0601_0002, "attempt to write a read-only object"),
    (0x0602_0000, "object does not exist"),
    (0x0604_0041, "object cannot be mapped to the PDO"),
    (0x0604_0042, "the mapped objects would exceed the PDO's length"),
    (0x0604_0043, "general parameter incompatibility"),
    (0x0604_0047, "general internal incompatibility in the device"),
    (0x0606_0000, "access failed due to a hardware error"),
    (0x0607_0010, "data type does not match, length does not match"),
    (0x0607_0012, "data type does not match, length too high"),
    (0x0607_0013, "data type does not match, length too low"),
    (0x0609_0011, "sub-index does not exist"),
    (0x0609_0030, "invalid value for the parameter"),
    (0x0609_0031, "value of the parameter written too high"),
    (0x0609_0032, "value of the parameter written too low"),
    (0x0609_0036, "maximum value is less than minimum value"),
    (0x060A_0023, "resource not available: SDO connection"),
    (0x0800_0000, "general error"),
    (0x0800_0020, "data cannot be transferred or stored to the application"),
    (0x0800_0021, "data cannot be transferred because of local control"),
    (
        0x0800_0022,
        "data cannot be transferred because of the present device state",
    ),
    (0x0800_0023, "no object dictionary is present"),
    (0x0800_0024, "no data available"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_meanings_stand_in_the_order_of_their_codes() {
        assert!(MEANINGS.is_sorted_by_key(|meaning| meaning.0));
    }

    #[test]
    fn a_code_is_shown_as_the_standard_prints_it() {
        assert_eq!(
            AbortCode::NO_SUCH_SUB_INDEX.to_string(),
            "0609 0011h (sub-index does not exist)"
        );
        assert_eq!(AbortCode(0x1234_5678).to_string(), "1234 5678h");
    }
}
