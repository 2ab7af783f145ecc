use super::lists::{is_plain, lists};
use crate::{
    Reading,
    diagnostic::Level,
    fix::{Change, Fix},
    ir::{ObjectList, Problem},
    rules::{ReadingRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds objects that are twice in a list, or in two lists.
    ///
    /// ## Why it matters
    /// Readers count the object twice, or refuse the file.
    ///
    /// ## Example
    /// ```ini
    /// [MandatoryObjects]
    /// SupportedObjects=3
    /// 1=0x1000
    /// 2=0x1001
    /// 3=0x1018
    ///
    /// [OptionalObjects]
    /// SupportedObjects=2
    /// 1=0x1017
    /// 2=0x1017
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=1
    /// 1=0x1017
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, object lists; CANchkEDS V37
    pub(crate) TwiceListedObject { code: "EDS015", level: Level::Warn, since: "0.1.0", fixable: Sometimes }
}

impl ReadingRule for TwiceListedObject {
    fn check(reading: &Reading, report: &mut Report) {
        for problem in &reading.problems {
            if let Problem::ListedTwice { index, at, first } = *problem {
                report
                    .at(at, format!("object {index:04X}h is listed a second time"))
                    .label("the second time")
                    .related(first, "the first time")
                    .help("keep it in the list that it belongs in")
                    .fix(needless(reading, index, first, at).map(|at| Fix::new(Change::Strike { at })));
            }
        }
    }
}

/// Which of the two lines goes: the second, unless only that one is in the list that the object belongs in.
fn needless(reading: &Reading, index: u16, first: Span, again: Span) -> Option<Span> {
    let list_of = |at: Span| {
        let mut lists = lists(&reading.eds).filter(|(_, list)| list.values().any(|listed| listed.span == at));
        lists.next()
    };
    let ((one, one_list), (other, other_list)) = (list_of(first)?, list_of(again)?);
    let home = ObjectList::of(index);
    let plain = is_plain(one_list) && is_plain(other_list);
    plain.then_some(if other == home && one != home { first } else { again })
}
