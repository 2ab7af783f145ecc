use super::{answers::answered, shown::shown};
use crate::{
    diagnostic::Level,
    dump::Dump,
    ir::{Address, Dictionary, NodeId},
    rules::{DumpRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds COB-IDs of the default SDO server (1200h) that are not 600h and 580h plus the node-ID.
    ///
    /// ## Why it matters
    /// They cannot be anything else: by them the dump was taken. A tool that believes 1200h talks to another node, or to none.
    ///
    /// ## Example
    /// ```json
    /// "node": 5,
    /// "1200sub1": "00 06 00 00"
    /// ```
    ///
    /// ## Reference
    /// CiA 301, object 1200h; CiA's conformance test SDO12
    pub(crate) WrongSdoCobId { code: "DMP016", level: Level::Deny, since: "0.1.0" }
}

impl DumpRule for WrongSdoCobId {
    fn check(dictionary: &Dictionary, dump: &Dump, report: &mut Report) {
        for answer in answered(dictionary, dump) {
            let Some(expected) = predefined(answer.entry.address, dump.node_id).map(u32::to_le_bytes) else {
                continue;
            };
            if answer.fits() && answer.bytes != expected {
                let data_type = answer.entry.data_type;
                let (found, expected) = (shown(answer.bytes, data_type), shown(&expected, data_type));
                let (name, node) = (answer.named(), dump.node_id.get());
                report
                    .at(
                        answer.entry.spans.default,
                        format!("{name} answers {found}; node {node} has {expected}"),
                    )
                    .help("let the device add its node-ID");
            }
        }
    }
}

/// The COB-ID that CiA 301 fixes for `address`, if it does.
pub(super) fn predefined(address: Address, node_id: NodeId) -> Option<u32> {
    let node = u32::from(node_id.get());
    match (address.index, address.sub) {
        (0x1200, 1) => Some(0x600 + node),
        (0x1200, 2) => Some(0x580 + node),
        _ => None,
    }
}
