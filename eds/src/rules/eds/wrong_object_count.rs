use super::lists::{is_plain, lists};
use crate::{
    diagnostic::Level,
    fix::{Change, Fix},
    ir::ObjectList,
    model::{Eds, List},
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds lists whose SupportedObjects is not the number of objects that are listed.
    ///
    /// ## Why it matters
    /// A reader that trusts the count loses the objects beyond it, or looks for objects that are not listed.
    ///
    /// ## Example
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=1
    /// 1=0x1008
    /// 2=0x1017
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
    /// CiA 306-1, object lists; CANchkEDS V5
    pub(crate) WrongObjectCount { code: "EDS005", level: Level::Warn, since: "0.1.0", fixable: Sometimes }
}

impl ModelRule for WrongObjectCount {
    fn check(eds: &Eds, report: &mut Report) {
        for (name, list) in lists(eds) {
            check_list(name, list, report);
        }
    }
}

fn check_list(name: ObjectList, list: &List<u16>, report: &mut Report) {
    let Some(count) = list.count else { return };
    let listed = list.items.len();
    if count.value as usize != listed {
        let objects = if listed == 1 { "object is" } else { "objects are" };
        report
            .at(
                count.span,
                format!("SupportedObjects is {}, but {listed} {objects} listed", count.value),
            )
            .help(format!("write `SupportedObjects={listed}`"))
            .fix(is_plain(list).then(|| Fix::new(Change::Number { list: name })));
    }
}
