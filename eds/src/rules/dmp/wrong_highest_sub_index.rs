use super::answers::has_sub_indices;
use crate::{
    diagnostic::Level,
    dump::{Answer, Dump},
    ir::{Address, Dictionary, Entry, Object, Value},
    rules::{DumpRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds arrays and records whose sub-index 0 does not say what is there: a sub-index above it answers, the one that it
    /// names does not exist, or was not asked for because the file says another one.
    ///
    /// ## Why it matters
    /// A tool without the file reads sub-index 0 and then that many. It misses values, or runs into an abort.
    ///
    /// ## Example
    /// ```json
    /// "1018sub0": "02",
    /// "1018sub3": "01 00 00 00"
    /// ```
    /// Not looked at: sub-indices 0 that can be written, the number of errors (1003h) and the numbers of mapped objects (1600h
    /// and 1A00h and following), because they count what is in use.
    ///
    /// ## Reference
    /// CiA 301, sub-index 00h of an array or record: highest sub-index supported; CANchkEDS V36
    pub(crate) WrongHighestSubIndex { code: "DMP008", level: Level::Deny, since: "0.1.0" }
}

impl DumpRule for WrongHighestSubIndex {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        for object in &dictionary.objects {
            let entry = object
                .entries
                .first()
                .filter(|entry| is_highest_sub_index(object, entry));
            let Some(entry) = entry.filter(|entry| entry.access.readable()) else {
                continue;
            };
            let Some(&[says]) = dump.value(entry.address) else {
                continue;
            };
            if let Some(contradiction) = contradiction(object, entry, dump, says) {
                let message = format!("{} answers {says}; {contradiction}", entry.address);
                report
                    .at(entry.spans.default, message)
                    .help("make sub-index 0 the highest sub-index, in the device and in the file");
            }
        }
    }
}

/// Whether the value is the highest sub-index of its object.
pub(super) fn is_highest_sub_index(object: &Object, entry: &Entry) -> bool {
    let counts_what_is_in_use = matches!(object.index, 0x1003 | 0x1600..=0x17FF | 0x1A00..=0x1BFF);
    entry.address.sub == 0 && has_sub_indices(object) && !entry.access.writable() && !counts_what_is_in_use
}

/// What sub-index 0, which `says` a number, contradicts. A number that fits the device but not the file is left to the rules
/// about undeclared and missing sub-indices.
fn contradiction(object: &Object, entry: &Entry, dump: &Dump, says: u8) -> Option<String> {
    let highest = highest_found(object.index, dump);
    if highest > says {
        return Some(format!("sub-index {highest} answers too"));
    }
    // One that the file has is reported as missing.
    if object.entry(says).is_none() && is_absent(Address::new(object.index, says), dump) {
        return Some(format!("there is no sub-index {says}"));
    }
    match entry.default {
        Some(Value::Unsigned(number)) if highest < says && number != u64::from(says) => {
            Some(format!("the file says {number}"))
        }
        _ => None,
    }
}

fn is_absent(address: Address, dump: &Dump) -> bool {
    dump.answer(address).is_some_and(Answer::is_absence)
}

/// The highest sub-index that answers with anything but its absence; FFh, the structure, is none of them.
fn highest_found(index: u16, dump: &Dump) -> u8 {
    let found = dump
        .object(index)
        .filter(|(address, answer)| address.sub < 0xFF && is_presence(answer));
    found.map(|(address, _)| address.sub).max().unwrap_or(0)
}

const fn is_presence(answer: &Answer) -> bool {
    match answer {
        Answer::Value(_) => true,
        Answer::Abort(_) => !answer.is_absence(),
        Answer::Timeout => false,
    }
}
