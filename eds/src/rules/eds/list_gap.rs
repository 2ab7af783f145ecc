use super::lists::{is_plain, lists};
use crate::{
    diagnostic::Level,
    fix::{Change, Fix},
    model::Eds,
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds lists of objects whose lines are not numbered 1, 2, 3 … without a gap.
    ///
    /// ## Why it matters
    /// A reader that counts from 1 to SupportedObjects stops at the gap, and does not find the last objects.
    ///
    /// ## Example
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=2
    /// 1=0x1008
    /// 3=0x1017
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=2
    /// 1=0x1008
    /// 2=0x1017
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, object lists; CANchkEDS W3
    pub(crate) ListGap { code: "EDS014", level: Level::Warn, since: "0.1.0", fixable: Sometimes }
}

impl ModelRule for ListGap {
    fn check(eds: &Eds, report: &mut Report) {
        for (name, list) in lists(eds) {
            let mut numbers: Vec<_> = list.items.iter().map(|item| item.number).collect();
            numbers.sort_by_key(|number| number.value);
            numbers.dedup_by_key(|number| number.value);
            let gap = numbers
                .iter()
                .zip(1..)
                .find(|(number, expected)| number.value != *expected);
            if let Some((number, expected)) = gap {
                report
                    .at(
                        number.span,
                        format!("line {} of the list is here, line {expected} is missing", number.value),
                    )
                    .help("number the lines 1, 2, 3 …")
                    .fix(is_plain(list).then(|| Fix::new(Change::Number { list: name })));
            }
        }
    }
}
