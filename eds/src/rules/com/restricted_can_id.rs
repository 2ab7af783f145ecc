use super::cob_ids::{CanId, services};
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds SYNC, TIME, EMCY and PDOs whose COB-ID after power-on is kept for another service: NMT (000h), SDO (581h to 5FFh, 601h to
    /// 67Fh), boot-up and heartbeat (701h to 77Fh), and the other restricted ones (001h to 07Fh, 101h to 180h, 6E0h to 6FFh, from 780h).
    ///
    /// ## Why it matters
    /// Two services under one CAN-ID disturb each other; under 000h a PDO starts and stops all the nodes of the network.
    ///
    /// ## Example
    /// ```ini
    /// [1800sub1]
    /// ParameterName=COB-ID used by TPDO
    /// DefaultValue=$NODEID+0x580
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1800sub1]
    /// ParameterName=COB-ID used by TPDO
    /// DefaultValue=$NODEID+0x180
    /// ```
    ///
    /// ## Reference
    /// CiA 301, 7.3.5, restricted CAN-IDs
    pub(crate) RestrictedCanId { code: "COM003", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for RestrictedCanId {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        // A number without $NODEID, where the node-ID is to be added, is COM014.
        for service in services(dictionary).into_iter().filter(|service| !service.is_fixed()) {
            if let Some(owner) = owner(service.can_id) {
                let (name, place) = (service.name, service.entry.spans.default);
                let value = report.quote(place);
                report
                    .at(place, format!("COB-ID {value} of {name} is {owner}"))
                    .help("take a CAN-ID of the predefined connection set, or set bit 31 to switch it off");
            }
        }
    }
}

/// Whose the CAN-ID is, for node 1 if it is a formula.
pub(super) fn owner(can_id: CanId) -> Option<&'static str> {
    match can_id.base + u16::from(can_id.with_node_id) {
        0x000 => Some("that of NMT"),
        0x581..=0x5FF | 0x601..=0x67F => Some("one of SDO"),
        0x701..=0x77F => Some("one of heartbeat"),
        0x001..=0x07F | 0x101..=0x180 | 0x6E0..=0x6FF | 0x780.. => Some("restricted"),
        _ => None,
    }
}
