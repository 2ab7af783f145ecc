//! The static data types of CiA 301.

/// A data type (CiA 301, table 44). A type that the standard does not define is lowered to [`DataType::Domain`], because
/// nothing is known of its bytes; the model keeps the number that the file gave.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "the standard's names")]
pub enum DataType {
    Boolean,
    Integer8,
    Integer16,
    Integer32,
    Unsigned8,
    Unsigned16,
    Unsigned32,
    Real32,
    VisibleString,
    OctetString,
    UnicodeString,
    TimeOfDay,
    TimeDifference,
    Domain,
    Integer24,
    Real64,
    Integer40,
    Integer48,
    Integer56,
    Integer64,
    Unsigned24,
    Unsigned40,
    Unsigned48,
    Unsigned56,
    Unsigned64,
}

/// Every data type with its index in the dictionary, its name in the standard and its length in bits (0: variable).
const FACTS: [(DataType, u16, &str, u8); 25] = [
    (DataType::Boolean, 0x01, "BOOLEAN", 1),
    (DataType::Integer8, 0x02, "INTEGER8", 8),
    (DataType::Integer16, 0x03, "INTEGER16", 16),
    (DataType::Integer32, 0x04, "INTEGER32", 32),
    (DataType::Unsigned8, 0x05, "UNSIGNED8", 8),
    (DataType::Unsigned16, 0x06, "UNSIGNED16", 16),
    (DataType::Unsigned32, 0x07, "UNSIGNED32", 32),
    (DataType::Real32, 0x08, "REAL32", 32),
    (DataType::VisibleString, 0x09, "VISIBLE_STRING", 0),
    (DataType::OctetString, 0x0A, "OCTET_STRING", 0),
    (DataType::UnicodeString, 0x0B, "UNICODE_STRING", 0),
    (DataType::TimeOfDay, 0x0C, "TIME_OF_DAY", 48),
    (DataType::TimeDifference, 0x0D, "TIME_DIFFERENCE", 48),
    (DataType::Domain, 0x0F, "DOMAIN", 0),
    (DataType::Integer24, 0x10, "INTEGER24", 24),
    (DataType::Real64, 0x11, "REAL64", 64),
    (DataType::Integer40, 0x12, "INTEGER40", 40),
    (DataType::Integer48, 0x13, "INTEGER48", 48),
    (DataType::Integer56, 0x14, "INTEGER56", 56),
    (DataType::Integer64, 0x15, "INTEGER64", 64),
    (DataType::Unsigned24, 0x16, "UNSIGNED24", 24),
    (DataType::Unsigned40, 0x18, "UNSIGNED40", 40),
    (DataType::Unsigned48, 0x19, "UNSIGNED48", 48),
    (DataType::Unsigned56, 0x1A, "UNSIGNED56", 56),
    (DataType::Unsigned64, 0x1B, "UNSIGNED64", 64),
];

impl DataType {
    /// The type with `index` in the dictionary, `0x01..=0x1B`; `None` for one that CiA 301 does not define there.
    #[must_use]
    pub fn from_index(index: u16) -> Option<Self> {
        FACTS.iter().find(|facts| facts.1 == index).map(|facts| facts.0)
    }

    /// The type with the standard's name, in any case: `UNSIGNED32`.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        let found = FACTS.iter().find(|facts| facts.2.eq_ignore_ascii_case(name));
        found.map(|facts| facts.0)
    }

    fn facts(self) -> &'static (Self, u16, &'static str, u8) {
        // `FACTS` stands in the order of the enum; a test holds it to that.
        &FACTS[self as usize]
    }

    /// The type's index in the dictionary.
    #[must_use]
    pub fn index(self) -> u16 {
        self.facts().1
    }

    /// The standard's name: `UNSIGNED32`.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.facts().2
    }

    /// The length in bits, as in a PDO mapping; `None` for strings and domains.
    #[must_use]
    pub fn bits(self) -> Option<u8> {
        Some(self.facts().3).filter(|&bits| bits != 0)
    }

    /// The length in bytes, as in an SDO transfer; `None` for strings and domains.
    #[must_use]
    pub fn bytes(self) -> Option<usize> {
        self.bits().map(|bits| usize::from(bits).div_ceil(8))
    }

    /// Whether it is INTEGER8 to INTEGER64.
    #[must_use]
    pub fn is_signed(self) -> bool {
        self.name().starts_with("INTEGER")
    }

    /// Whether values of it are smaller and larger than others, so that limits mean something: BOOLEAN, integers, reals.
    #[must_use]
    pub fn is_ordered(self) -> bool {
        self.bits().is_some() && !matches!(self, Self::TimeOfDay | Self::TimeDifference)
    }

    /// Whether it is UNSIGNED8 to UNSIGNED64.
    #[must_use]
    pub fn is_unsigned(self) -> bool {
        self.name().starts_with("UNSIGNED")
    }
}

#[cfg(test)]
mod tests {
    use super::FACTS;

    #[test]
    fn the_facts_stand_in_the_order_of_the_enum() {
        for (place, facts) in FACTS.iter().enumerate() {
            assert_eq!(facts.0 as usize, place);
        }
    }
}
