use std::collections::BTreeMap;

use crate::{
    diagnostic::Level,
    ir::{Dictionary, Entry, Value},
    rules::{DictionaryRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds values of 1016h, consumer heartbeat time, that a device must refuse: one with reserved bits, one with a time but a node-ID
    /// above 127, and two with a time for one node-ID.
    ///
    /// ## Why it matters
    /// The value cannot be written back: the device answers with abort code 0604 0043h, and a tool that restores the device's
    /// parameters fails there.
    ///
    /// ## Example
    /// ```ini
    /// [1016sub1]
    /// DefaultValue=0x000505DC
    /// [1016sub2]
    /// DefaultValue=0x000503E8
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1016sub2]
    /// DefaultValue=0x000603E8
    /// ```
    ///
    /// ## Reference
    /// CiA 301, object 1016h
    pub(crate) WrongHeartbeatConsumer { code: "COM016", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for WrongHeartbeatConsumer {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        let mut consumed: BTreeMap<u8, Span> = BTreeMap::new();
        for entry in dictionary.object(0x1016).into_iter().flat_map(|object| &object.entries) {
            let Some(node) = watched_node(entry) else { continue };
            let (address, at) = (entry.address, entry.spans.default);
            match u8::try_from(node).ok().filter(|node| *node < 128) {
                None => {
                    report
                        .at(at, format!("{address} is for node-ID {node}; node-IDs end at 127"))
                        .help("write the node-ID in bits 16 to 22, the time in bits 0 to 15");
                }
                // Node-ID 0 is an entry that is not in use.
                Some(0) => {}
                Some(node) => {
                    if let Some(first) = consumed.insert(node, at) {
                        report
                            .at(
                                at,
                                format!("{address} is for node-ID {node}, which has an entry already"),
                            )
                            .related(first, "the other one")
                            .help("write 0 in one of them");
                    }
                }
            }
        }
    }
}

/// The bits above the time, of an entry that has a time.
const fn watched_node(entry: &Entry) -> Option<u64> {
    match entry.default {
        Some(Value::Unsigned(value)) if entry.address.sub > 0 && value & 0xFFFF != 0 => Some(value >> 16),
        _ => None,
    }
}
