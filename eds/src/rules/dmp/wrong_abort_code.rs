use super::answers::named;
use crate::{
    diagnostic::Level,
    dump::{AbortCode, Answer, Dump},
    ir::{Address, Dictionary},
    rules::{DumpRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds a sub-index that the device refuses as if the object did not exist (0602 0000h) while other sub-indices of it
    /// answer, and an object refused as if only the sub-index did not exist (0609 0011h) while it has not even a sub-index 0.
    /// One finding for an object.
    ///
    /// ## Why it matters
    /// A tool that looks for objects takes 0602 0000h for the end of the object and misses the sub-indices that follow.
    ///
    /// ## Example
    /// ```json
    /// "1018sub0": "04",
    /// "1018sub5": { "abort": "0x06020000" }
    /// ```
    ///
    /// ## Reference
    /// CiA 301, SDO abort codes; CiA's conformance test SDO05 and SDO06
    pub(crate) WrongAbortCode { code: "DMP014", level: Level::Warn, since: "0.1.0" }
}

impl DumpRule for WrongAbortCode {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        let mut reported = None;
        for (&address, answer) in &dump.objects {
            let Some((sent, right)) = mistaken(address, answer, dump).filter(|_| reported != Some(address.index))
            else {
                continue;
            };
            let object = dictionary.object(address.index);
            let span = object.map_or(Span::default(), |object| object.span);
            let name = object.map_or_else(|| address.to_string(), |object| named(object, address));
            report
                .at(
                    span,
                    format!("the device aborts with {sent} for {name}; it has to be {right}"),
                )
                .help("check the index first, then the sub-index");
            reported = Some(address.index);
        }
    }
}

/// The code that the device sent, and the one that it should have.
fn mistaken(address: Address, answer: &Answer, dump: &Dump) -> Option<(AbortCode, AbortCode)> {
    let is_there = || dump.object(address.index).any(|(_, other)| other.value().is_some());
    let is_absent_at_zero = || {
        dump.answer(Address::new(address.index, 0))
            .is_some_and(Answer::is_absence)
    };
    match *answer {
        Answer::Abort(sent @ AbortCode::NO_SUCH_OBJECT) if is_there() => Some((sent, AbortCode::NO_SUCH_SUB_INDEX)),
        Answer::Abort(sent @ AbortCode::NO_SUCH_SUB_INDEX) if is_absent_at_zero() && !is_there() => {
            Some((sent, AbortCode::NO_SUCH_OBJECT))
        }
        _ => None,
    }
}
