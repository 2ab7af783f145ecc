use std::ops::RangeInclusive;

use crate::{
    diagnostic::Level,
    fix::Fix,
    model::{Eds, FileInfo},
    rules::{ModelRule, Report, declare_rule},
    span::Spanned,
};

declare_rule! {
    /// ## What it does
    /// Finds times of day that are not written as the standard has it: `hh:mmAM` or `hh:mmPM`. Hours of one digit are let pass.
    ///
    /// ## Why it matters
    /// No two tools read another form alike; most pass over it.
    ///
    /// ## Example
    /// ```ini
    /// [FileInfo]
    /// CreationTime=14:05
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [FileInfo]
    /// CreationTime=02:05PM
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, [FileInfo]
    pub(crate) WrongTime { code: "EDS018", level: Level::Note, since: "0.1.0", fixable: Sometimes }
}

impl ModelRule for WrongTime {
    fn check(eds: &Eds, report: &mut Report) {
        let times = eds.file_info.iter().flat_map(times);
        for (keyword, time) in times.filter(|(_, time)| !time.value.is_empty() && !is_time(&time.value)) {
            let value = report.quote(time.span);
            let certain = certain(&time.value);
            report
                .at(
                    time.span,
                    format!("{keyword} {value} is not a time of the form hh:mmAM or hh:mmPM"),
                )
                .help(match &certain {
                    Some(time) => format!("write `{time}`"),
                    None => "write hours up to 12, minutes, and AM or PM, such as 02:05PM".to_owned(),
                })
                .fix(certain.map(|certain| Fix::replace(time.span, certain)));
        }
    }
}

fn times(info: &FileInfo) -> impl Iterator<Item = (&'static str, &Spanned<String>)> {
    let times = [
        ("CreationTime", &info.creation_time),
        ("ModificationTime", &info.modification_time),
    ];
    times
        .into_iter()
        .filter_map(|(keyword, time)| Some((keyword, time.as_ref()?)))
}

fn is_time(text: &str) -> bool {
    let clock = text.strip_suffix("AM").or_else(|| text.strip_suffix("PM"));
    let Some((hours, minutes)) = clock.and_then(|clock| clock.split_once(':')) else {
        return false;
    };
    is_number(hours, 1..=2, 12) && is_number(minutes, 2..=2, 59)
}

/// The time that `text` must be, in the standard's form. `10:41` may be in the evening, and the seconds of `13:23:28` would be lost.
fn certain(text: &str) -> Option<String> {
    let upper = text.to_ascii_uppercase();
    let suffix = ["AM", "PM"].into_iter().find(|half| upper.ends_with(half));
    let clock = upper.strip_suffix(suffix.unwrap_or_default())?.trim_end();
    let (hours, minutes) = clock.split_once(':')?;
    let hour: u8 = hours.parse().ok().filter(|_| is_number(hours, 1..=2, 23))?;
    let half = match (suffix, hour) {
        (Some("AM"), 0..=12) | (None, 0) => "AM",
        (Some("PM"), 1..) | (None, 13..) => "PM",
        _ => return None,
    };
    let hour = match hour % 12 {
        0 => 12,
        hour => hour,
    };
    is_number(minutes, 2..=2, 59).then(|| format!("{hour:02}:{minutes}{half}"))
}

/// Whether `text` is a number of so many digits, at most `largest`.
fn is_number(text: &str, digits: RangeInclusive<usize>, largest: u8) -> bool {
    let all_digits = digits.contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_digit());
    all_digits && text.parse::<u8>().is_ok_and(|number| number <= largest)
}

#[cfg(test)]
mod tests {
    use super::{certain, is_time};

    #[test]
    fn a_time_is_hours_minutes_and_the_half_of_the_day() {
        assert!(is_time("09:30AM") && is_time("12:00PM") && is_time("9:30AM"));
        for wrong in [
            "13:05PM",
            "09:30",
            "09:30 AM",
            "09:30:00AM",
            "09:60AM",
            "930AM",
            "+9:30AM",
            ":30AM",
        ] {
            assert!(!is_time(wrong), "{wrong}");
        }
    }

    #[test]
    fn a_time_is_certain_when_the_half_of_the_day_cannot_be_mistaken() {
        for (text, time) in [
            ("08:55 PM", "08:55PM"),
            ("3:46pm", "03:46PM"),
            ("21:37PM", "09:37PM"),
            ("14:05", "02:05PM"),
            ("00:15", "12:15AM"),
            ("0:15 am", "12:15AM"),
            ("12:00 pm", "12:00PM"),
        ] {
            assert_eq!(certain(text).as_deref(), Some(time), "{text}");
        }
        for doubtful in [
            "10:41", "12:00", "21:37AM", "0:15PM", "13:23:28", "24:00", "13:60", "+9:30 AM", "PM", "ÄM",
        ] {
            assert_eq!(certain(doubtful), None, "{doubtful}");
        }
    }
}
