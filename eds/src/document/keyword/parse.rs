//! From the text of a key to its keyword.

use std::str::FromStr;

use super::{Keyword, PLAIN};

impl Keyword {
    /// The keyword that `key` spells, in any case; [`Keyword::Unknown`] when it is none.
    #[must_use]
    pub fn parse(key: &str) -> Self {
        match key.as_bytes() {
            [b'0'..=b'9', ..] => number(key),
            [.., b'0'..=b'9'] | [b'D' | b'd', b'U' | b'u', ..] => numbered(key).unwrap_or(Self::Unknown),
            _ => plain(key),
        }
    }
}

/// `1` or `0x0005`.
fn number(key: &str) -> Keyword {
    match after(key, "0x") {
        Some(digits) => hex(digits).map_or(Keyword::Unknown, Keyword::DataTypeIndex),
        None => decimal(key).map_or(Keyword::Unknown, Keyword::Number),
    }
}

/// A word and a number.
fn numbered(key: &str) -> Option<Keyword> {
    let number = |word| decimal(after(key, word)?);
    match key.as_bytes().first()? {
        b'D' | b'd' => match after(key, "Dummy") {
            Some(digits) => hex(digits).map(Keyword::Dummy),
            None => number("Dir").map(Keyword::Dir),
        },
        b'L' | b'l' => number("Line").map(Keyword::Line),
        b'B' | b'b' => decimal(after(key, "BaudRate_")?).map(Keyword::BaudRate),
        b'T' | b't' => number("Type").map(Keyword::Type),
        b'R' | b'r' => number("Range").map(Keyword::Range),
        b'P' | b'p' => number("PPOffset").map(Keyword::PpOffset),
        b'M' | b'm' => number("MaxCnt").map(Keyword::MaxCnt),
        _ => None,
    }
}

/// What follows `word`, which may be in any case.
fn after<'a>(key: &'a str, word: &str) -> Option<&'a str> {
    let (start, rest) = key.split_at_checked(word.len())?;
    start.eq_ignore_ascii_case(word).then_some(rest)
}

/// Decimal digits and nothing else.
fn decimal<T: FromStr>(digits: &str) -> Option<T> {
    digits
        .bytes()
        .all(|byte| byte.is_ascii_digit())
        .then(|| digits.parse().ok())?
}

/// One to four hexadecimal digits and nothing else.
pub(super) fn hex(digits: &str) -> Option<u16> {
    let all_hex = digits.len() <= 4 && digits.bytes().all(|byte| byte.is_ascii_hexdigit());
    all_hex.then(|| u16::from_str_radix(digits, 16).ok())?
}

/// A word without a number: the one that may stand in the key's slot, if it does.
fn plain(key: &str) -> Keyword {
    let found = SLOTS
        .get(usize::from(slot(key.as_bytes())))
        .and_then(|at| PLAIN.get(usize::from(*at)));
    found
        .filter(|(_, name)| *name == key || name.eq_ignore_ascii_case(key))
        .map_or(Keyword::Unknown, |(keyword, _)| *keyword)
}

/// For each slot the place in [`PLAIN`] of the keyword that falls into it. No two fall into one: this does not compile
/// otherwise, and [`slot`] needs other factors.
#[expect(
    clippy::cast_possible_truncation,
    reason = "there are fewer than 255 keywords, which is asserted"
)]
const SLOTS: [u8; 256] = {
    assert!(PLAIN.len() < u8::MAX as usize);
    let mut slots = [u8::MAX; 256];
    let mut at = 0;
    while at < PLAIN.len() {
        let slot = slot(PLAIN[at].1.as_bytes()) as usize;
        assert!(slots[slot] == u8::MAX, "two keywords in one slot");
        slots[slot] = at as u8;
        at += 1;
    }
    slots
};

/// Mixes the length and three letters of `key`, whatever their case. The factors are such that all keywords differ.
const fn slot(key: &[u8]) -> u8 {
    let [first, .., before_last, _] = key else { return 0 };
    let middle = key[key.len() / 2] | 0x20;
    let mixed =
        key.len() * 2 + (*first | 0x20) as usize * 157 + middle as usize * 104 + (*before_last | 0x20) as usize * 188;
    mixed.to_le_bytes()[0]
}

#[cfg(test)]
mod tests {
    use super::super::Keyword::{self, *};
    use super::PLAIN;

    #[test]
    fn every_keyword_is_known_in_any_case() {
        for (keyword, name) in PLAIN {
            assert_eq!(Keyword::parse(name), *keyword, "{name}");
            assert_eq!(Keyword::parse(&name.to_uppercase()), *keyword, "{name}");
            assert_eq!(Keyword::parse(&name.to_lowercase()), *keyword, "{name}");
            assert!(keyword.is_spelled(name), "{name}");
            assert!(!keyword.is_spelled(&name.to_lowercase()), "{name}");
        }
    }

    #[test]
    fn numbered_keywords_carry_their_number() {
        for (key, keyword) in [
            ("1", Number(1)),
            ("254", Number(254)),
            ("Line12", Line(12)),
            ("Dummy0005", Dummy(5)),
            ("Dummy001B", Dummy(0x1B)),
            ("BaudRate_1000", BaudRate(1000)),
            ("0x001B", DataTypeIndex(0x1B)),
            ("Type1", Type(1)),
            ("Dir2", Dir(2)),
            ("Range3", Range(3)),
            ("PPOffset4", PpOffset(4)),
            ("MaxCnt5", MaxCnt(5)),
        ] {
            assert_eq!(Keyword::parse(key), keyword, "{key}");
            assert!(keyword.is_spelled(key), "{key}");
        }
    }

    #[test]
    fn other_spellings_are_understood_and_told() {
        for (key, keyword) in [
            ("Baudrate_500", BaudRate(500)),
            ("line5", Line(5)),
            ("DUMMY0005", Dummy(5)),
            ("Dummy5", Dummy(5)),
            ("01", Number(1)),
            ("0X0005", DataTypeIndex(5)),
            ("BaudRate", CommissionedBaudRate),
            ("NrOfRxPDO", NrOfRxPdo),
        ] {
            assert_eq!(Keyword::parse(key), keyword, "{key}");
            assert!(!keyword.is_spelled(key), "{key}");
        }
    }

    #[test]
    fn what_only_resembles_a_keyword_is_unknown() {
        for key in [
            "",
            "x",
            "Parameter",
            "ParameterName1",
            "Parameter Name",
            "Line",
            "Line-1",
            "Line99999999999",
            "BaudRate_",
            "Dummy00005",
            "BaudRate_70000",
            "BaudRate_fast",
            "Dummy",
            "DummyXYZW",
            "Dummy+005",
            "4294967296",
            "1a",
            "0x",
            "0x10000",
            "0x+5",
            "ä",
            "DataTypé",
        ] {
            assert_eq!(Keyword::parse(key), Unknown, "{key}");
            assert!(!Unknown.is_spelled(key), "{key}");
        }
    }
}
