use super::{difference::differences, unapplied_parameter::is_parameter};
use crate::{
    diagnostic::Level,
    dump::Dump,
    ir::{AccessType, Dictionary},
    rules::{DumpRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds values that are not the file's default, of objects that may change: all but the constants and a DCF's parameters.
    ///
    /// ## Why it matters
    /// For most it does not: a process value moves, a setting was set. After a factory reset it does: then a setting's
    /// default in the file is wrong.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// AccessType=rw
    /// DefaultValue=0
    /// ```
    /// for a device that answers 1000.
    ///
    /// ## Reference
    /// CiA 306-1, DefaultValue; CiA's conformance test OD02
    pub(crate) ChangedDefault { code: "DMP005", level: Level::Note, since: "0.1.0" }
}

impl DumpRule for ChangedDefault {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        for difference in differences(dictionary, dump) {
            let entry = difference.answer.entry;
            if entry.access != AccessType::Const && !is_parameter(entry) {
                report
                    .at(entry.spans.default, difference.message())
                    .help("restore the defaults (1011h) and take the dump again, if it is to be compared");
            }
        }
    }
}
