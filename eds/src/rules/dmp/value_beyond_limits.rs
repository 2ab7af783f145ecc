use std::cmp::Ordering;

use super::{
    answers::{Answered, answered},
    difference::is_default,
    shown::shown,
};
use crate::{
    diagnostic::Level,
    dump::Dump,
    ir::{Dictionary, NodeId, Value},
    rules::{DumpRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds values below LowLimit or above HighLimit. A value that is the file's own default is left to `lexican check`.
    ///
    /// ## Why it matters
    /// The device holds a value that, by its file, it would refuse. Either the limits are not the device's, and a master
    /// keeps its user from valid values, or the device does not enforce them.
    ///
    /// ## Example
    /// ```ini
    /// [2000]
    /// HighLimit=10
    /// ```
    /// for a device that answers 11.
    ///
    /// ## Reference
    /// CiA 306-1, LowLimit and HighLimit; CiA's conformance test OD06
    pub(crate) ValueBeyondLimits { code: "DMP006", level: Level::Deny, since: "0.1.0" }
}

impl DumpRule for ValueBeyondLimits {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        for answer in answered(dictionary, dump) {
            let Some(Limit { word, value, span }) = exceeded(&answer, dump.node_id) else {
                continue;
            };
            let data_type = answer.entry.data_type;
            let limit = shown(&value.to_bytes(data_type, Some(dump.node_id)), data_type);
            let found = shown(answer.bytes, data_type);
            let message = format!("{} answers {found}; {word} is {limit}", answer.named());
            report.at(span, message).help("give the limits that the device has");
        }
    }
}

/// A limit that a value does not keep.
pub(super) struct Limit<'a> {
    word: &'static str,
    value: &'a Value,
    span: Span,
}

/// The limit that the device's value does not keep; `None` for the file's own default.
pub(super) fn exceeded<'a>(answer: &Answered<'a>, node_id: NodeId) -> Option<Limit<'a>> {
    let entry = answer.entry;
    let value = Value::from_bytes(answer.bytes, entry.data_type)?;
    let beyond = |limit: &Value, side| value.compare(limit, Some(node_id)) == Some(side);
    let low = entry.low.as_ref().filter(|low| beyond(low, Ordering::Less));
    let high = entry.high.as_ref().filter(|high| beyond(high, Ordering::Greater));
    let low = low.map(|value| Limit {
        word: "LowLimit",
        value,
        span: entry.spans.low,
    });
    let high = high.map(|value| Limit {
        word: "HighLimit",
        value,
        span: entry.spans.high,
    });
    low.or(high).filter(|_| !is_default(answer, node_id))
}
