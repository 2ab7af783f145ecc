//! Numbers in the text of a log.

/// `number`, all of which are hexadecimal digits, up to eight.
pub(super) fn hexadecimal(number: &[u8]) -> Option<u32> {
    digits(number, 16, 8)
}

/// `number`, all of which are decimal digits, up to nine.
pub(super) fn decimal(number: &[u8]) -> Option<u32> {
    digits(number, 10, 9)
}

fn digits(number: &[u8], base: u32, longest: usize) -> Option<u32> {
    if number.is_empty() || number.len() > longest {
        return None;
    }
    number
        .iter()
        .try_fold(0, |sum, &digit| Some(sum * base + char::from(digit).to_digit(base)?))
}

/// `seconds`, such as `1436509052.249713`, in µs. More digits than six behind the point are cut off.
pub(super) fn micros(seconds: &[u8]) -> Option<u64> {
    let point = seconds.iter().position(|&byte| byte == b'.').unwrap_or(seconds.len());
    let (whole, fraction) = seconds.split_at_checked(point)?;
    let fraction = fraction.get(1..).unwrap_or_default();
    plain_micros(whole, fraction).or_else(|| exponential_micros(seconds))
}

fn plain_micros(whole: &[u8], fraction: &[u8]) -> Option<u64> {
    if whole.is_empty() || whole.len() > 12 {
        return None;
    }
    let mut micros = whole.iter().try_fold(0, |micros, &digit| with_digit(micros, digit))?;
    let mut places = fraction.iter();
    for _ in 0..6 {
        micros = with_digit(micros, places.next().copied().unwrap_or(b'0'))?;
    }
    places.all(u8::is_ascii_digit).then_some(micros)
}

fn with_digit(number: u64, digit: u8) -> Option<u64> {
    digit.is_ascii_digit().then(|| number * 10 + u64::from(digit - b'0'))
}

/// Python writes a time below 0.1 ms as `5e-05`.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the range is looked at before"
)]
fn exponential_micros(seconds: &[u8]) -> Option<u64> {
    if !seconds.first()?.is_ascii_digit() {
        return None;
    }
    let seconds: f64 = str::from_utf8(seconds).ok()?.parse().ok()?;
    (0.0..1e12).contains(&seconds).then(|| (seconds * 1e6).round() as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seconds_become_microseconds() {
        let cases: [(&str, Option<u64>); 12] = [
            ("1436509052.249713", Some(1_436_509_052_249_713)),
            ("0.0", Some(0)),
            ("3", Some(3_000_000)),
            ("3.5", Some(3_500_000)),
            ("1.0000009", Some(1_000_000)),
            ("5e-05", Some(50)),
            ("", None),
            (".5", None),
            ("-1.0", None),
            ("1.2x", None),
            ("nan", None),
            ("9999999999999999999.0", None),
        ];
        for (text, expected) in cases {
            assert_eq!(micros(text.as_bytes()), expected, "{text}");
        }
    }

    #[test]
    fn a_number_is_all_digits_and_not_too_many() {
        assert_eq!(hexadecimal(b"1FfFFFFF"), Some(0x1FFF_FFFF));
        assert_eq!(decimal(b"2047"), Some(2047));
        for none in ["", "+1", "1FFFFFFFF", "0x1", "1 "] {
            assert_eq!(hexadecimal(none.as_bytes()), None, "{none}");
        }
        assert_eq!(decimal(b"A"), None);
    }
}
