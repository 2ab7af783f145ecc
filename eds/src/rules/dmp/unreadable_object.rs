use super::answers::{asked, named};
use crate::{
    diagnostic::Level,
    dump::{AbortCode, Answer, Dump},
    ir::Dictionary,
    rules::{DumpRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects that the file declares readable and the device does not let be read: abort code 0601 0001h or 0601 0000h.
    ///
    /// ## Why it matters
    /// A master or a tool that reads what the file says it may read gets an abort instead.
    ///
    /// ## Example
    /// ```ini
    /// [2001]
    /// AccessType=rw
    /// ```
    /// for a device that answers `{ "abort": "0x06010001" }`.
    ///
    /// ## Reference
    /// CiA 306-1, AccessType; CiA's conformance test OD01
    pub(crate) UnreadableObject { code: "DMP009", level: Level::Deny, since: "0.1.0" }
}

impl DumpRule for UnreadableObject {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        for (object, entry, answer) in asked(dictionary, dump) {
            if let Some(code) = refusal(answer).filter(|_| entry.access.readable()) {
                let (name, access) = (named(object, entry.address), entry.access.name());
                report
                    .at(
                        entry.spans.access,
                        format!("{name} is {access} in the file; the device aborts with {code}"),
                    )
                    .help("declare it wo, or make the device answer");
            }
        }
    }
}

/// The abort code, if it says that the object cannot be read at all.
pub(super) fn refusal(answer: &Answer) -> Option<AbortCode> {
    match *answer {
        Answer::Abort(code @ (AbortCode::WRITE_ONLY | AbortCode::UNSUPPORTED_ACCESS)) => Some(code),
        _ => None,
    }
}
