use super::standard::standard;
use crate::{
    diagnostic::Level,
    ir::{Address, Dictionary, Value},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds $NODEID in a communication object whose value has nothing to do with the node-ID: a time, a count, a mapping, an identity.
    ///
    /// ## Why it matters
    /// The value differs from node to node, and nobody expects it: two devices of a kind have different heartbeat times.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// DefaultValue=$NODEID+1000
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// DefaultValue=1000
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, `$NODEID`; CiA 301, 7.3.3
    pub(crate) MisplacedNodeId { code: "COM022", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for MisplacedNodeId {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for entry in dictionary.entries().filter(|entry| !may_depend(entry.address)) {
            if matches!(entry.default, Some(Value::NodeIdPlus(_))) {
                let (address, name) = (
                    entry.address,
                    standard(entry.address.index).map_or("", |standard| standard.name),
                );
                report
                    .at(
                        entry.spans.default,
                        format!("{address} of {name} depends on the node-ID"),
                    )
                    .help("write a number without $NODEID");
            }
        }
    }
}

/// Whether the value may differ from node to node: a COB-ID, the node-ID, whom the device watches, or an object that no
/// standard knows.
fn may_depend(address: Address) -> bool {
    matches!(
        (address.index, address.sub),
        (0x1005 | 0x100B | 0x100E | 0x1012 | 0x1014, 0)
            | (0x1016 | 0x1028 | 0x1200..=0x12FF, 1..)
            | (0x1301..=0x1340, 5 | 6)
            | (0x1400..=0x15FF | 0x1800..=0x19FF, 1)
    ) || standard(address.index).is_none()
}
