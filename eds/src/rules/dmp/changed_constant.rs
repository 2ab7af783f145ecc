use super::difference::differences;
use crate::{
    diagnostic::Level,
    dump::Dump,
    ir::{AccessType, Dictionary},
    rules::{DumpRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds constants that have another value on the device than in the file. The identity, COB-IDs of the SDO server and
    /// the highest sub-indices have rules of their own. NULs that fill up a VISIBLE_STRING do not count.
    ///
    /// ## Why it matters
    /// A const value never changes, so tools take it from the file and never read it; here they take a wrong one. Mostly the
    /// file is of another version of the firmware.
    ///
    /// ## Example
    /// ```ini
    /// [1008]
    /// AccessType=const
    /// DefaultValue=WDGA
    /// ```
    /// for a device that answers `WDGB`.
    ///
    /// ## Reference
    /// CiA 306-1, AccessType; CiA's conformance test OD02
    pub(crate) ChangedConstant { code: "DMP004", level: Level::Deny, since: "0.1.0" }
}

impl DumpRule for ChangedConstant {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        for difference in differences(dictionary, dump) {
            let entry = difference.answer.entry;
            if entry.access == AccessType::Const {
                report
                    .at(entry.spans.default, difference.message())
                    .help("take the file of this firmware, or declare the object ro");
            }
        }
    }
}
