use std::ops::RangeInclusive;

use crate::{
    diagnostic::Level,
    model::{Eds, FileInfo},
    rules::{ModelRule, Report, declare_rule},
    span::Spanned,
};

declare_rule! {
    /// ## What it does
    /// Finds dates that are not written as the standard has it: month, day, year as `mm-dd-yyyy`.
    ///
    /// ## Why it matters
    /// Tools that sort files by date, or show the newest, put them in the wrong place. `03-04-2021` is in March.
    ///
    /// ## Example
    /// ```ini
    /// [FileInfo]
    /// CreationDate=2021-03-04
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [FileInfo]
    /// CreationDate=03-04-2021
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, [FileInfo]
    pub(crate) WrongDate { code: "EDS017", level: Level::Note, since: "0.1.0" }
}

impl ModelRule for WrongDate {
    fn check(eds: &Eds, report: &mut Report) {
        let dates = eds.file_info.iter().flat_map(dates);
        for (keyword, date) in dates.filter(|(_, date)| !date.value.is_empty() && !is_date(&date.value)) {
            let value = report.quote(date.span);
            report
                .at(
                    date.span,
                    format!("{keyword} {value} is not a date of the form mm-dd-yyyy"),
                )
                .help("write month, day and year, such as 03-04-2021 for the fourth of March");
        }
    }
}

fn dates(info: &FileInfo) -> impl Iterator<Item = (&'static str, &Spanned<String>)> {
    let dates = [
        ("CreationDate", &info.creation_date),
        ("ModificationDate", &info.modification_date),
    ];
    dates
        .into_iter()
        .filter_map(|(keyword, date)| Some((keyword, date.as_ref()?)))
}

fn is_date(text: &str) -> bool {
    let mut parts = text.split('-');
    let mut number = |digits, range| parts.next().is_some_and(|part| is_number(part, digits, range));
    number(2, 1..=12) && number(2, 1..=31) && number(4, 0..=9999) && parts.next().is_none()
}

/// Whether `text` is a number of so many digits in the range.
fn is_number(text: &str, digits: usize, range: RangeInclusive<u16>) -> bool {
    let all_digits = text.len() == digits && text.bytes().all(|byte| byte.is_ascii_digit());
    all_digits && text.parse().is_ok_and(|number| range.contains(&number))
}

#[cfg(test)]
mod tests {
    use super::is_date;

    #[test]
    fn a_date_is_month_day_and_year() {
        assert!(is_date("12-31-2026") && is_date("01-01-1999"));
        for wrong in [
            "31-12-2026",
            "2026-12-31",
            "1-1-2026",
            "12-31-26",
            "12/31/2026",
            "+1-01-2026",
            "12-00-2026",
            "12-31-2026-",
        ] {
            assert!(!is_date(wrong), "{wrong}");
        }
    }
}
