use super::difference::differences;
use crate::{
    diagnostic::Level,
    dump::Dump,
    ir::{Dictionary, Entry},
    rules::{DumpRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds settings that the device does not have as a DCF's ParameterValue gives them. Process values, which may be mapped
    /// into a PDO, do not count.
    ///
    /// ## Why it matters
    /// A DCF is the configuration of this very node. The device was not configured by it, has lost it, or was changed since.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// AccessType=rw
    /// DefaultValue=0
    /// ParameterValue=1000
    /// ```
    /// for a device that answers 0.
    ///
    /// ## Reference
    /// CiA 306-1, ParameterValue
    pub(crate) UnappliedParameter { code: "DMP019", level: Level::Warn, since: "0.1.0" }
}

impl DumpRule for UnappliedParameter {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        for difference in differences(dictionary, dump) {
            let entry = difference.answer.entry;
            if is_parameter(entry) {
                report
                    .at(entry.spans.default, difference.message())
                    .help("download the configuration and store it, or take the value over into the file");
            }
        }
    }
}

/// Whether a DCF says what the value has to be.
pub(super) const fn is_parameter(entry: &Entry) -> bool {
    entry.configured && entry.access.writable() && !entry.pdo_mapping
}
