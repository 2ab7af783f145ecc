use super::lists::is_open;
use crate::{
    Reading,
    diagnostic::Level,
    fix::{Change, Fix},
    ir::{ObjectList, Problem},
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects that have a section but are in none of the lists `[MandatoryObjects]`, `[OptionalObjects]` and
    /// `[ManufacturerObjects]`.
    ///
    /// ## Why it matters
    /// Readers that go by the lists do not see the object, readers that go by the sections do: a master and a generator build two
    /// different devices from one file.
    ///
    /// ## Example
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=0
    ///
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=1
    /// 1=0x1017
    ///
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, object lists
    pub(crate) UnlistedObject { code: "EDS006", level: Level::Warn, since: "0.1.0", fixable: Sometimes }
}

impl ReadingRule for UnlistedObject {
    fn check(reading: &Reading, report: &mut Report) {
        let lists = [ObjectList::Mandatory, ObjectList::Optional, ObjectList::Manufacturer];
        let open: Vec<_> = lists.into_iter().filter(|list| is_open(&reading.eds, *list)).collect();
        for problem in &reading.problems {
            if let Problem::UnlistedObject { index, at } = *problem {
                let list = ObjectList::of(index);
                let fix = Fix::new(Change::Enlist { list, index });
                report
                    .at(at, format!("object {index:04X}h is in no list"))
                    .help(format!("add it to [{}]", list.section()))
                    .fix(open.contains(&list).then_some(fix));
            }
        }
    }
}
