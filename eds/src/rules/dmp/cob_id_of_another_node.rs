use super::{
    answers::{Answered, answered},
    shown::shown,
    wrong_sdo_cob_id::predefined,
};
use crate::{
    diagnostic::Level,
    dump::Dump,
    ir::{DataType, Dictionary, NodeId, Value},
    rules::{DumpRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds COB-IDs that are by the file `$NODEID` plus a number, and on the device that number plus the node-ID of another
    /// node. The bits above the CAN-ID do not count.
    ///
    /// ## Why it matters
    /// The device got another node-ID and kept, or stored, the COB-IDs of the old one. As soon as a node with the old
    /// node-ID joins, both send the same CAN-ID.
    ///
    /// ## Example
    /// ```ini
    /// [1014]
    /// DefaultValue=$NODEID+0x80
    /// ```
    /// for a dump of node 5 with `83 00 00 00`.
    ///
    /// ## Reference
    /// CiA 301, predefined connection set; CiA 306-1, `$NODEID`
    pub(crate) CobIdOfAnotherNode { code: "DMP017", level: Level::Warn, since: "0.1.0" }
}

impl DumpRule for CobIdOfAnotherNode {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        for answer in answered(dictionary, dump) {
            if predefined(answer.entry.address, dump.node_id).is_some() {
                continue;
            }
            if let Some(other) = other_node(&answer, dump.node_id) {
                let (name, node) = (answer.named(), dump.node_id.get());
                let found = shown(answer.bytes, answer.entry.data_type);
                let message = format!("{name} answers {found}, the COB-ID of node {other}; the dump is of node {node}");
                report
                    .at(answer.entry.spans.default, message)
                    .help("restore the defaults (1011h), and store them under the new node-ID");
            }
        }
    }
}

/// The other node whose COB-ID the device answered.
pub(super) fn other_node(answer: &Answered<'_>, node_id: NodeId) -> Option<u8> {
    const CAN_ID: u64 = 0x1FFF_FFFF;
    let entry = answer.entry;
    let Some(Value::NodeIdPlus(base)) = entry.default else {
        return None;
    };
    let Some(Value::Unsigned(value)) = Value::from_bytes(answer.bytes, entry.data_type) else {
        return None;
    };
    let node = u8::try_from((value & CAN_ID).checked_sub(base & CAN_ID)?).ok()?;
    let is_other = entry.data_type == DataType::Unsigned32 && node != node_id.get();
    NodeId::new(node).filter(|_| is_other).map(NodeId::get)
}
