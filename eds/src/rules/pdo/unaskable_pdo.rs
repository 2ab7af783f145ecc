use super::mapped::label;
use crate::{
    diagnostic::Level,
    ir::{Dictionary, Direction, Entry, Value},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds TPDOs that are sent only on request (transmission type 252 or 253), but whose COB-ID has bit 30: no request allowed.
    ///
    /// ## Why it matters
    /// Such a TPDO is never sent.
    ///
    /// ## Example
    /// ```ini
    /// [1800sub1]
    /// DefaultValue=$NODEID+0x40000180
    /// [1800sub2]
    /// DefaultValue=253
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1800sub1]
    /// DefaultValue=$NODEID+0x180
    /// ```
    ///
    /// ## Reference
    /// CiA 301, object 1800h
    pub(crate) UnaskablePdo { code: "PDO026", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for UnaskablePdo {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for pdo in dictionary.pdos(Direction::Transmit) {
            let of = |sub| pdo.communication.and_then(|object| object.entry(sub));
            let Some((cob_id, transmission_type)) = of(1).zip(of(2)) else {
                continue;
            };
            let asked = matches!(transmission_type.default, Some(Value::Unsigned(252 | 253)));
            if asked && is_mute(cob_id) {
                let at = cob_id.spans.default;
                let (pdo, value) = (label(&pdo), report.quote(at));
                report
                    .at(at, format!("{pdo} is sent on request only, but {value} allows none"))
                    .related(transmission_type.spans.default, "its transmission type")
                    .help("clear bit 30 of the COB-ID, or take another transmission type");
            }
        }
    }
}

/// The PDO does not exist: bit 31.
const INVALID: u64 = 1 << 31;
/// No remote frame may ask for it: bit 30.
const NO_REQUEST: u64 = 1 << 30;

/// Whether a PDO exists and nobody may ask for it.
const fn is_mute(cob_id: &Entry) -> bool {
    match cob_id.default {
        Some(Value::Unsigned(value) | Value::NodeIdPlus(value)) => value & (INVALID | NO_REQUEST) == NO_REQUEST,
        _ => false,
    }
}
