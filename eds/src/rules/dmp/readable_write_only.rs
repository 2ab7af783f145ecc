use super::{
    answers::{asked, named},
    shown::shown,
};
use crate::{
    diagnostic::Level,
    dump::{AbortCode, Answer, Dump},
    ir::Dictionary,
    rules::{DumpRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects that the file declares write-only and that the device lets be read, or refuses with another abort code
    /// than 0601 0001h.
    ///
    /// ## Why it matters
    /// The file hides a value that is there, or the device's access rights are not what they were meant to be.
    ///
    /// ## Example
    /// ```ini
    /// [2002]
    /// AccessType=wo
    /// ```
    /// for a device that answers `00`.
    ///
    /// ## Reference
    /// CiA 301, SDO abort codes; CiA's conformance test OD04
    pub(crate) ReadableWriteOnly { code: "DMP010", level: Level::Warn, since: "0.1.0" }
}

impl DumpRule for ReadableWriteOnly {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        for (object, entry, answer) in asked(dictionary, dump) {
            let found = match answer {
                _ if entry.access.readable() => continue,
                Answer::Value(bytes) => format!("answers {}", shown(bytes, entry.data_type)),
                Answer::Abort(code) if !answer.is_absence() && *code != AbortCode::WRITE_ONLY => {
                    format!("aborts with {code}")
                }
                _ => continue,
            };
            let name = named(object, entry.address);
            report
                .at(
                    entry.spans.access,
                    format!("{name} is wo in the file; the device {found}"),
                )
                .help("declare it rw, or make the device abort with 0601 0001h");
        }
    }
}
