use crate::{
    diagnostic::Level,
    ir::NodeId,
    model::Eds,
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds a NodeID in `[DeviceComissioning]` that no node can have: they go from 1 to 127.
    ///
    /// ## Why it matters
    /// No COB-ID can be made with it: `$NODEID+0x180` would be another service's, or none.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceComissioning]
    /// NodeID=0
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceComissioning]
    /// NodeID=5
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, 5.3; CiA 301, 4.5.1
    pub(crate) ImpossibleNodeId { code: "DCF005", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for ImpossibleNodeId {
    fn check(eds: &Eds, report: &mut Report) {
        let node_id = eds.commissioning.as_ref().and_then(|section| section.node_id);
        if let Some(node_id) = node_id.filter(|node_id| NodeId::new(node_id.value).is_none()) {
            let value = report.quote(node_id.span);
            report
                .at(node_id.span, format!("NodeID is {value}; nodes have 1 to 127"))
                .help("give the node's number");
        }
    }
}
