use std::ops::RangeInclusive;

use crate::{
    diagnostic::Level,
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
    pub(crate) WrongTime { code: "EDS018", level: Level::Note, since: "0.1.0" }
}

impl ModelRule for WrongTime {
    fn check(eds: &Eds, report: &mut Report) {
        let times = eds.file_info.iter().flat_map(times);
        for (keyword, time) in times.filter(|(_, time)| !time.value.is_empty() && !is_time(&time.value)) {
            let value = report.quote(time.span);
            report
                .at(
                    time.span,
                    format!("{keyword} {value} is not a time of the form hh:mmAM or hh:mmPM"),
                )
                .help("write hours up to 12, minutes, and AM or PM, such as 02:05PM");
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

/// Whether `text` is a number of so many digits, at most `largest`.
fn is_number(text: &str, digits: RangeInclusive<usize>, largest: u8) -> bool {
    let all_digits = digits.contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_digit());
    all_digits && text.parse::<u8>().is_ok_and(|number| number <= largest)
}

#[cfg(test)]
mod tests {
    use super::is_time;

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
}
