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
    pub(crate) WrongDate { code: "EDS017", level: Level::Note, since: "0.1.0", fixable: Sometimes }
}

impl ModelRule for WrongDate {
    fn check(eds: &Eds, report: &mut Report) {
        let dates = eds.file_info.iter().flat_map(dates);
        for (keyword, date) in dates.filter(|(_, date)| !date.value.is_empty() && !is_date(&date.value)) {
            let value = report.quote(date.span);
            let certain = certain(&date.value);
            report
                .at(
                    date.span,
                    format!("{keyword} {value} is not a date of the form mm-dd-yyyy"),
                )
                .help(match &certain {
                    Some(date) => format!("write `{date}`"),
                    None => "write month, day and year, such as 03-04-2021 for the fourth of March".to_owned(),
                })
                .fix(certain.map(|certain| Fix::replace(date.span, certain)));
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

/// The date that `text` must be, in the standard's form: the year comes first, the month is a name, or the day is too large for
/// a month. Of `03/04/2021` nobody knows, nor of the century of `99`.
fn certain(text: &str) -> Option<String> {
    let mut parts = text.split(['-', '/', '.']);
    let (first, second, third) = (parts.next()?, parts.next()?, parts.next()?);
    if parts.next().is_some() {
        return None;
    }
    let (month, day, year) = match (number(first), number(second)) {
        (Some(_), Some(_)) if first.len() == 4 => (number(second)?, number(third)?, first),
        (Some(day), Some(month)) if day > 12 || day == month => (month, day, third),
        (Some(month), Some(day)) if day > 12 => (month, day, third),
        (Some(day), None) => (month_of_name(second)?, day, third),
        (None, Some(day)) => (month_of_name(first)?, day, third),
        _ => return None,
    };
    let date = format!("{month:02}-{day:02}-{year}");
    is_date(&date).then_some(date)
}

/// A number of at most four digits.
fn number(text: &str) -> Option<u16> {
    let all_digits = text.len() <= 4 && text.bytes().all(|byte| byte.is_ascii_digit());
    text.parse().ok().filter(|_| all_digits)
}

/// 1 to 12, by the first letters of the English name or all of it.
fn month_of_name(name: &str) -> Option<u16> {
    const MONTHS: [&str; 12] = [
        "january",
        "february",
        "march",
        "april",
        "may",
        "june",
        "july",
        "august",
        "september",
        "october",
        "november",
        "december",
    ];
    let name = name.to_ascii_lowercase();
    let named = |month: &&str| name.len() >= 3 && month.starts_with(&name);
    (1..)
        .zip(&MONTHS)
        .find_map(|(number, month)| named(month).then_some(number))
}

/// Whether `text` is a number of so many digits in the range.
fn is_number(text: &str, digits: usize, range: RangeInclusive<u16>) -> bool {
    let all_digits = text.len() == digits && text.bytes().all(|byte| byte.is_ascii_digit());
    all_digits && text.parse().is_ok_and(|number| range.contains(&number))
}

#[cfg(test)]
mod tests {
    use super::{certain, is_date};

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

    #[test]
    fn a_date_is_certain_when_day_month_and_year_cannot_be_mistaken() {
        for (text, date) in [
            ("2021-03-04", "03-04-2021"),
            ("2021/3/4", "03-04-2021"),
            ("07-Feb-2016", "02-07-2016"),
            ("September-4-2021", "09-04-2021"),
            ("15-06-2007", "06-15-2007"),
            ("17/07/2024", "07-17-2024"),
            ("7/17/2024", "07-17-2024"),
            ("5.5.2020", "05-05-2020"),
        ] {
            assert_eq!(certain(text).as_deref(), Some(date), "{text}");
        }
        for doubtful in [
            "03/04/2021",
            "1-2-2021",
            "10-26-99",
            "15-01-99",
            "2021-13-01",
            "31-31-2021",
            "07-Fe-2016",
            "2021-03-04 10:00",
            "-",
        ] {
            assert_eq!(certain(doubtful), None, "{doubtful}");
        }
    }
}
