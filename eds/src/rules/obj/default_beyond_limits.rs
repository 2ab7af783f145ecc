use std::cmp::Ordering;

use crate::{
    diagnostic::Level,
    ir::{Dictionary, Entry, NodeId, Value},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds values after power-on (DefaultValue, or ParameterValue in a DCF) below the LowLimit or above the HighLimit of their
    /// object.
    ///
    /// ## Why it matters
    /// The device starts with a value that it would refuse: a master that saves and restores its parameters gets an abort.
    ///
    /// ## Example
    /// ```ini
    /// [6098]
    /// ParameterName=Homing method
    /// DataType=0x0002
    /// DefaultValue=0
    /// LowLimit=1
    /// HighLimit=35
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6098]
    /// ParameterName=Homing method
    /// DataType=0x0002
    /// DefaultValue=1
    /// LowLimit=1
    /// HighLimit=35
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, LowLimit and HighLimit; CiA 301, abort codes 0609 0031h and 0609 0032h
    pub(crate) DefaultBeyondLimits { code: "OBJ001", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for DefaultBeyondLimits {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for entry in dictionary.entries() {
            check_entry(entry, report);
        }
    }
}

fn check_entry(entry: &Entry, report: &mut Report) {
    let Some(default) = &entry.default else { return };
    // Of a formula only what is wrong for every node.
    let (least, most) = (NodeId::new(1), NodeId::new(127));
    let lies = |side: Ordering, limit: &Option<Value>, node_id: Option<NodeId>| {
        let order = limit.as_ref().and_then(|limit| default.compare(limit, node_id));
        order == Some(side)
    };
    let inverted = entry.low.as_ref().zip(entry.high.as_ref());
    let inverted = inverted.and_then(|(low, high)| low.compare(high, None)) == Some(Ordering::Greater);
    let too_low = lies(Ordering::Less, &entry.low, most);
    let too_high = lies(Ordering::Greater, &entry.high, least);
    let (limit, fact) = match (too_low, too_high) {
        // That is OBJ002.
        _ if inverted => return,
        (true, _) => (entry.spans.low, "below its LowLimit"),
        (_, true) => (entry.spans.high, "above its HighLimit"),
        _ => return,
    };
    let keyword = if entry.configured {
        "ParameterValue"
    } else {
        "DefaultValue"
    };
    let (value, bound) = (report.quote(entry.spans.default), report.quote(limit));
    report
        .at(entry.spans.default, format!("{keyword} {value} is {fact} {bound}"))
        .related(limit, "the limit")
        .help("fix the value or the limit");
}
