use super::{Encoder, standard::Mapping};
use crate::{
    diagnostic::Level,
    ir::{Direction, Object},
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds measured values of CiA 406 that cannot be mapped into a PDO, and settings that can.
    ///
    /// ## Why it matters
    /// Positions, speeds, cam states and area states are what an encoder has PDOs for: a master that maps one of them gets abort
    /// 0604 0041h. A setting in a PDO is changed without an answer. Where no client can change what TPDOs carry, the values that
    /// they do not carry are left alone.
    ///
    /// 6301h, 6302h, 6503h and 6505h are left alone: V2.0 and encoders of V3.2 contradict each other.
    ///
    /// ## Example
    /// ```ini
    /// [6004]
    /// ParameterName=Position value
    /// PDOMapping=0
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6004]
    /// ParameterName=Position value
    /// PDOMapping=1
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, chapter 8, PDO Mapping; CANchkEDS V30
    pub(crate) WrongEncoderMapping { code: "ENC007", level: Level::Note, since: "0.1.0" }
}

impl EncoderRule for WrongEncoderMapping {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        let fixed = !has_variable_mapping(encoder);
        let mut last = None;
        for value in encoder.values(|spans| spans.pdo_mapping) {
            let (fact, cure) = match (value.standard.mapping, value.entry.pdo_mapping) {
                (Mapping::Possible, false) if !fixed => {
                    ("cannot be mapped; CiA 406 has it in PDOs", "write `PDOMapping=1`")
                }
                (Mapping::Impossible, true) => ("can be mapped; CiA 406 has it in no PDO", "write `PDOMapping=0`"),
                _ => continue,
            };
            // One channel stands for all.
            let index = value.entry.address.index;
            if last.replace(index) == Some(index) {
                continue;
            }
            report.at(value.at, format!("{} {fact}", value.named())).help(cure);
        }
    }
}

/// Whether a client can change what a TPDO carries.
fn has_variable_mapping(encoder: &Encoder<'_>) -> bool {
    let mut pdos = encoder.dictionary.pdos(Direction::Transmit);
    let writable = |mapping: &Object| mapping.entries.iter().any(|entry| entry.access.writable());
    pdos.any(|pdo| pdo.mapping.is_some_and(writable))
}
