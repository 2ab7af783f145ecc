use std::cmp::Ordering;

use crate::{
    diagnostic::Level,
    ir::{Dictionary, Entry},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds writable objects whose LowLimit is above their HighLimit. In a signed type a hex number with the top bit set is negative: 0xFF
    /// of INTEGER8 is -1.
    ///
    /// ## Why it matters
    /// No value is within the limits. A device made from the file refuses every write, a master every input.
    ///
    /// ## Example
    /// ```ini
    /// [6060]
    /// ParameterName=Modes of operation
    /// DataType=0x0002
    /// LowLimit=0x00
    /// HighLimit=0xFF
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6060]
    /// ParameterName=Modes of operation
    /// DataType=0x0002
    /// LowLimit=-128
    /// HighLimit=127
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, LowLimit and HighLimit. Of an object that is only read it is OBJ022.
    pub(crate) InvertedLimits { code: "OBJ002", level: Level::Deny, since: "0.1.0" }
}

impl DictionaryRule for InvertedLimits {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for entry in dictionary.entries().filter(|entry| entry.access.writable()) {
            check_limits(entry, report);
        }
    }
}

pub(super) fn check_limits(entry: &Entry, report: &mut Report) {
    let (Some(low), Some(high)) = (&entry.low, &entry.high) else {
        return;
    };
    if low.compare(high, None) == Some(Ordering::Greater) {
        let (low, high) = (report.quote(entry.spans.low), report.quote(entry.spans.high));
        let data_type = entry.data_type.name();
        report
            .at(
                entry.spans.low,
                format!("LowLimit {low} is above HighLimit {high} of this {data_type}"),
            )
            .related(entry.spans.high, "the HighLimit")
            .help("fix the limits, or leave them out");
    }
}
