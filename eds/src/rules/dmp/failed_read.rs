use super::{
    answers::{asked, is_empty_error, named},
    silent_object::is_silence,
    unreadable_object::refusal,
};
use crate::{
    diagnostic::Level,
    dump::{Answer, Dump},
    ir::Dictionary,
    rules::{DumpRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds readable objects that the device has but could not tell when it was asked: an abort code that speaks of its state,
    /// of its hardware or of the transfer.
    ///
    /// ## Why it matters
    /// The value is not known, so nothing was compared. It may be in order, such as a program that is only there in a boot
    /// loader. An entry of 1003h above the number of errors has no value, and is not reported.
    ///
    /// ## Example
    /// ```json
    /// "2004sub0": { "abort": "0x08000022" }
    /// ```
    ///
    /// ## Reference
    /// CiA 301, SDO abort codes
    pub(crate) FailedRead { code: "DMP013", level: Level::Warn, since: "0.1.0" }
}

impl DumpRule for FailedRead {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        for (object, entry, answer) in asked(dictionary, dump) {
            let spoken_for = answer.is_absence() || refusal(answer).is_some() || is_silence(answer);
            if !entry.access.readable() || spoken_for || is_empty_error(entry.address, dump) {
                continue;
            }
            if let Answer::Abort(code) = answer {
                let name = named(object, entry.address);
                report
                    .at(
                        entry.spans.section,
                        format!("{name} could not be read: the device aborts with {code}"),
                    )
                    .help("bring the device into a state in which it answers, and take the dump again");
            }
        }
    }
}
