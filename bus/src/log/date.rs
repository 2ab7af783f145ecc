//! The date and time of day that `candump -t A` writes.

use super::number::{decimal, micros};

/// `2015-07-10` and `08:17:32.249713` in µs since 1970, as if they were of UTC: the log does not say the time zone.
pub(super) fn date_micros(date: &[u8], time: &[u8]) -> Option<u64> {
    let mut date = date.split(|&byte| byte == b'-').map(decimal);
    let (year, month, day) = (date.next()??, date.next()??, date.next()??);
    let mut time = time.splitn(3, |&byte| byte == b':');
    let (hours, minutes, seconds) = (decimal(time.next()?)?, decimal(time.next()?)?, micros(time.next()?)?);
    let minutes = u64::from(days_since_1970(year, month, day)?) * 1440 + u64::from(hours) * 60 + u64::from(minutes);
    (hours < 24).then_some(minutes * 60_000_000 + seconds)
}

/// Of the Gregorian calendar.
fn days_since_1970(year: u32, month: u32, day: u32) -> Option<u32> {
    if !(1970..=9999).contains(&year) || !(1..=12).contains(&month) || !(1..=31).contains(&day) {
        return None;
    }
    // Years that begin in March have their leap day at the end.
    let (year, month) = if month > 2 {
        (year, month - 3)
    } else {
        (year - 1, month + 9)
    };
    let leap_days = year / 4 - year / 100 + year / 400;
    let days = year * 365 + leap_days + (153 * month + 2) / 5 + day - 1;
    // 1 January 1970.
    days.checked_sub(719_468)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_date_is_as_many_seconds_after_1970_as_the_date_command_says() {
        let cases = [
            ("1970-01-01", "00:00:00", 0),
            ("2015-07-10", "06:17:32.249713", 1_436_509_052_249_713),
            ("2024-02-29", "23:59:59.999999", 1_709_251_199_999_999),
            ("2000-03-01", "00:00:00.000000", 951_868_800_000_000),
        ];
        for (date, time, expected) in cases {
            assert_eq!(date_micros(date.as_bytes(), time.as_bytes()), Some(expected));
        }
        for (date, time) in [
            ("2015-13-10", "06:17:32"),
            ("2015-07", "06:17:32"),
            ("2015-07-10", "24:00:00"),
            ("x", "y"),
        ] {
            assert_eq!(date_micros(date.as_bytes(), time.as_bytes()), None);
        }
    }
}
