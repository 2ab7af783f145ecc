use super::answers::{asked, named};
use crate::{
    diagnostic::Level,
    dump::{AbortCode, Answer, Dump},
    ir::Dictionary,
    rules::{DumpRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects for which no answer came in time, or whose transfer the client or the device ended with 0504 0000h.
    ///
    /// ## Why it matters
    /// A device answers every SDO request, with an abort code at the least. A master that waits for this one stalls until its
    /// own time is over, at every start.
    ///
    /// ## Example
    /// ```json
    /// "2003sub0": { "timeout": true }
    /// ```
    ///
    /// ## Reference
    /// CiA 301, SDO protocol
    pub(crate) SilentObject { code: "DMP011", level: Level::Deny, since: "0.1.0" }
}

impl DumpRule for SilentObject {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        for (object, entry, answer) in asked(dictionary, dump) {
            if is_silence(answer) {
                let name = named(object, entry.address);
                report
                    .at(
                        entry.spans.section,
                        format!("the device did not answer for {name} in time"),
                    )
                    .help("read it once more with more patience; then look into the device");
            }
        }
    }
}

/// Whether nothing was heard in time.
pub(super) const fn is_silence(answer: &Answer) -> bool {
    matches!(answer, Answer::Timeout | Answer::Abort(AbortCode::TIMED_OUT))
}
