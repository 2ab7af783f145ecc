use std::collections::BTreeMap;

use super::{
    cob_ids::{CanId, Service, services},
    duplicate_cob_id::is_given,
};
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds RPDOs that after power-on listen to a CAN-ID under which the device itself sends, or to which another RPDO listens.
    ///
    /// ## Why it matters
    /// A device does not receive its own frames, so that such an RPDO never comes. Two RPDOs under one CAN-ID take the same bytes apart
    /// in two ways; mostly one of them was meant to have another.
    ///
    /// ## Example
    /// ```ini
    /// [1400sub1]
    /// DefaultValue=$NODEID+0x180
    ///
    /// [1800sub1]
    /// DefaultValue=$NODEID+0x180
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1400sub1]
    /// DefaultValue=$NODEID+0x200
    /// ```
    ///
    /// ## Reference
    /// CiA 301, 7.3.3, generic predefined connection set. Of two that send it is COM004.
    pub(crate) SharedReceiveCanId { code: "COM021", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for SharedReceiveCanId {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        let services = services(dictionary);
        let mut taken: BTreeMap<CanId, &Service<'_>> = BTreeMap::new();
        for service in services.iter().filter(|service| service.sends) {
            taken.entry(service.can_id).or_insert(service);
        }
        // A device may both send and receive SYNC and TIME; CAN-ID 0 is COM003.
        let receive = services.iter().filter(|service| !service.sends && is_given(service));
        for service in receive {
            if let Some(other) = taken.get(&service.can_id) {
                let at = service.entry.spans.default;
                let (name, value) = (&service.name, report.quote(at));
                let verb = if other.sends { "sends" } else { "listens" };
                report
                    .at(
                        at,
                        format!("{name} listens to {value}, under which {} {verb}", other.name),
                    )
                    .related(other.entry.spans.default, "the other one")
                    .help("give each its own, or set bit 31 to switch one off");
            }
            taken.entry(service.can_id).or_insert(service);
        }
    }
}
