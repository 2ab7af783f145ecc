use super::{
    cob_ids::{CanId, services},
    restricted_can_id::owner,
};
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds a SYNC, TIME, EMCY, or one of the first four RPDOs or TPDOs, that is switched on after power-on under another CAN-ID than
    /// that of the predefined connection set. What a DCF configures is left alone.
    ///
    /// ## Why it matters
    /// A master that has not read the file, or a colleague who looks at the bus, expects the service under its usual CAN-ID.
    ///
    /// ## Example
    /// ```ini
    /// [1800sub1]
    /// ParameterName=COB-ID used by TPDO
    /// DefaultValue=$NODEID+0x280
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
    /// CiA 301, 7.3.3, generic predefined connection set
    pub(crate) UnusualCobId { code: "COM013", level: Level::Note, since: "0.1.0" }
}

impl DictionaryRule for UnusualCobId {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        // What a DCF configures is the user's choice.
        if dictionary.commissioning.is_some() {
            return;
        }
        // A restricted CAN-ID is COM003, that of a single node COM014.
        let services = services(dictionary).into_iter();
        let plain = services.filter(|service| owner(service.can_id).is_none() && !service.is_fixed());
        for service in plain {
            let predefined = service.predefined.filter(|predefined| *predefined != service.can_id);
            if let Some(CanId { base, with_node_id }) = predefined {
                let (name, at) = (service.name, service.entry.spans.default);
                let value = report.quote(at);
                let formula = if with_node_id { "$NODEID+" } else { "" };
                report
                    .at(at, format!("COB-ID {value} of {name} is not the predefined one"))
                    .help(format!("write `{formula}0x{base:X}`"));
            }
        }
    }
}
