use super::mapped::{kind, label, pdos, unsigned};
use crate::{
    diagnostic::Level,
    ir::{Dictionary, Direction},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds transmission types that CiA 301 reserves: 241 to 251, and for an RPDO also 252 and 253, which are for PDOs sent on
    /// request.
    ///
    /// ## Why it matters
    /// When the PDO is sent or taken over is not defined; the device must refuse the value with abort code 0609 0030h.
    ///
    /// ## Example
    /// ```ini
    /// [1800sub2]
    /// ParameterName=Transmission type
    /// DefaultValue=241
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1800sub2]
    /// ParameterName=Transmission type
    /// DefaultValue=254
    /// ```
    ///
    /// ## Reference
    /// CiA 301, objects 1400h and 1800h
    pub(crate) ReservedTransmissionType { code: "PDO019", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for ReservedTransmissionType {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for pdo in pdos(dictionary) {
            let entry = pdo.communication.and_then(|object| object.entry(2));
            let Some(entry) = entry else { continue };
            let value = unsigned(entry.default.as_ref()).filter(|value| is_reserved(*value, pdo.direction));
            if let Some(value) = value {
                let (pdo, kind) = (label(&pdo), kind(pdo.direction));
                report
                    .at(
                        entry.spans.default,
                        format!("transmission type {value} of {pdo} is reserved for {kind}s"),
                    )
                    .help("write 0 to 240 for one that follows SYNC, 254 or 255 for an event");
            }
        }
    }
}

const fn is_reserved(transmission_type: u64, direction: Direction) -> bool {
    match direction {
        Direction::Receive => matches!(transmission_type, 241..=253),
        Direction::Transmit => matches!(transmission_type, 241..=251),
    }
}
