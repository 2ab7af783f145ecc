use super::cob_ids::{Service, services};
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds services of the device that send under the same CAN-ID after power-on: SYNC, TIME, EMCY and TPDOs.
    ///
    /// ## Why it matters
    /// Who receives the frame cannot tell which of them it is.
    ///
    /// ## Example
    /// ```ini
    /// [1800sub1]
    /// DefaultValue=$NODEID+0x180
    ///
    /// [1801sub1]
    /// DefaultValue=$NODEID+0x180
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1801sub1]
    /// DefaultValue=$NODEID+0x280
    /// ```
    ///
    /// ## Reference
    /// CiA 301, 7.3.5, predefined connection set
    pub(crate) DuplicateCobId { code: "COM004", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for DuplicateCobId {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        let mut senders: Vec<Service<'_>> = services(dictionary);
        senders.retain(|service| service.sends && is_given(service));
        senders.sort_by_key(|service| (service.can_id, service.entry.address));
        for pair in senders.windows(2) {
            let [first, second] = pair else { continue };
            if first.can_id == second.can_id {
                let value = report.quote(second.entry.spans.default);
                report
                    .at(
                        second.entry.spans.default,
                        format!("{} sends under {value}, as {} does", second.name, first.name),
                    )
                    .related(first.entry.spans.default, "the other one")
                    .help("give each its own, or set bit 31 to switch one off");
            }
        }
    }
}

/// Whether it has a CAN-ID: 0 is that of NMT, which is COM003.
pub(super) fn is_given(service: &Service<'_>) -> bool {
    service.can_id.base != 0 || service.can_id.with_node_id
}
