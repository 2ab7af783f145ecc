use super::answers::{is_empty_error, named};
use crate::{
    diagnostic::Level,
    dump::{Answer, Dump},
    ir::{Dictionary, Entry, Object},
    rules::{DumpRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects and sub-indices of the file that the device says do not exist, by abort code 0602 0000h or 0609 0011h.
    ///
    /// ## Why it matters
    /// A master configures what the file lists. Here its configuration stops with an abort, or a value that it shows is
    /// not there.
    ///
    /// ## Example
    /// ```json
    /// "2000sub0": { "abort": "0x06020000" }
    /// ```
    /// although the file has a section `[2000]`.
    ///
    /// ## Reference
    /// CiA 301, SDO abort codes; CiA's conformance test OD01
    pub(crate) MissingObject { code: "DMP001", level: Level::Deny, since: "0.1.0" }
}

impl DumpRule for MissingObject {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        for object in &dictionary.objects {
            let absent = object.entries.iter().filter(|entry| is_absent(entry, dump));
            if is_whole_object_absent(object, dump) {
                let index = object.index;
                report
                    .at(object.span, format!("the device has no object {index:04X}h"))
                    .help(CURE);
                continue;
            }
            for entry in absent {
                let name = named(object, entry.address);
                report
                    .at(entry.spans.section, format!("the device has no {name}"))
                    .help(CURE);
            }
        }
    }
}

const CURE: &str = "take it out of the file, or load the firmware that has it";

fn is_absent(entry: &Entry, dump: &Dump) -> bool {
    dump.answer(entry.address).is_some_and(Answer::is_absence) && !is_empty_error(entry.address, dump)
}

/// Whether no sub-index was found, sub-index 0 among them.
fn is_whole_object_absent(object: &Object, dump: &Dump) -> bool {
    let mut answers = object.entries.iter().map(|entry| dump.answer(entry.address));
    let first_is_absent = answers.next().flatten().is_some_and(Answer::is_absence);
    first_is_absent && answers.flatten().all(Answer::is_absence)
}
