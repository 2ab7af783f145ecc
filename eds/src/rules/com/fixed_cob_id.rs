use super::cob_ids::{Service, services};
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds an EMCY, or one of the first four RPDOs or TPDOs, whose COB-ID after power-on is a number for one node: 181h in place of
    /// $NODEID+180h. What a DCF configures is left alone.
    ///
    /// ## Why it matters
    /// All devices of the kind send under that CAN-ID, whatever their node-ID is. Two of them on a network disturb each other, and an
    /// EMCY under 80h is taken for SYNC.
    ///
    /// ## Example
    /// ```ini
    /// [1014]
    /// ParameterName=COB-ID EMCY
    /// DefaultValue=0x80
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1014]
    /// ParameterName=COB-ID EMCY
    /// DefaultValue=$NODEID+0x80
    /// ```
    ///
    /// ## Reference
    /// CiA 301, 7.3.3, generic predefined connection set; CiA 306-1, `$NODEID`
    pub(crate) FixedCobId { code: "COM014", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for FixedCobId {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        // A DCF is of one node.
        if dictionary.commissioning.is_some() {
            return;
        }
        for service in services(dictionary).into_iter().filter(Service::is_fixed) {
            let (name, at) = (&service.name, service.entry.spans.default);
            let value = report.quote(at);
            let base = service.predefined.map_or(0, |predefined| predefined.base);
            report
                .at(at, format!("COB-ID {value} of {name} is the same for each node"))
                .help(format!("write `$NODEID+0x{base:X}`"));
        }
    }
}
