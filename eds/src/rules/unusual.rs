//! Values that can be read but are written in an unusual way.

use crate::{
    document::Keyword,
    literal::Note,
    model::{Eds, Expected, Problem},
    span::Span,
};

/// A value and whose it is.
pub(crate) struct Unusual {
    /// The keyword, for a message.
    pub(crate) keyword: &'static str,
    /// What the keyword takes.
    pub(crate) expected: Expected,
    /// The value.
    pub(crate) at: Span,
}

/// The values that are written in the way of `note`.
pub(crate) fn unusual(eds: &Eds, note: Note) -> impl Iterator<Item = Unusual> + Clone {
    eds.problems().iter().filter_map(move |problem| match *problem {
        Problem::Unusual {
            keyword,
            expected,
            note: found,
            at,
        } if found == note => Some(Unusual {
            keyword: value_name(keyword),
            expected,
            at,
        }),
        _ => None,
    })
}

/// The keyword, for a message; a line of the compact form has a number in place of one.
pub(crate) const fn value_name(keyword: Keyword) -> &'static str {
    match keyword {
        Keyword::Number(_) => "value",
        keyword => keyword.name(),
    }
}

/// How to write a number that starts with 0: as what it is in octal, or as what it looks like.
pub(crate) fn octal_cure(text: &str) -> String {
    let decimal = text.trim_start_matches('0');
    match u64::from_str_radix(text, 8) {
        Ok(octal) => format!("write `{octal}`, or `{decimal}` if that is meant"),
        Err(_) => format!("write `{decimal}`"),
    }
}

/// The number that `text` must mean in spite of its leading zeros: with an 8 or a 9 in it, it is no octal number.
pub(crate) fn certain_decimal(text: &str) -> Option<String> {
    let digits = text.trim_start_matches(['+', '-']);
    let all_digits = digits.bytes().all(|byte| byte.is_ascii_digit());
    let sign = text.get(..text.len() - digits.len()).filter(|sign| sign.len() <= 1)?;
    (all_digits && digits.contains(['8', '9'])).then(|| format!("{sign}{}", digits.trim_start_matches('0')))
}

#[cfg(test)]
mod tests {
    use super::{certain_decimal, octal_cure};

    #[test]
    fn a_number_that_cannot_be_octal_is_decimal_and_any_other_remains_in_doubt() {
        assert_eq!(certain_decimal("08").as_deref(), Some("8"));
        assert_eq!(certain_decimal("-0019").as_deref(), Some("-19"));
        assert_eq!(certain_decimal("010"), None);
        assert_eq!(certain_decimal("08h"), None);
    }

    #[test]
    fn the_cure_of_a_leading_zero_shows_both_readings() {
        assert_eq!(octal_cure("0100"), "write `64`, or `100` if that is meant");
        assert_eq!(octal_cure("08"), "write `8`");
    }
}
