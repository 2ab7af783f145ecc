use super::{Encoder, encoder::EncoderValue, standard::Access};
use crate::{
    diagnostic::Level,
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds settings of CiA 406 that cannot be written, and measured values that can.
    ///
    /// ## Why it matters
    /// A master that sets scaling or preset gets abort 0601 0002h; one that restores all writable parameters overwrites a position.
    ///
    /// 6020h is left alone: V2.0 has it ro in the overview and rw in the text. 6005h is ro in the overview, which cannot be meant, as
    /// its values are settings.
    ///
    /// ## Example
    /// ```ini
    /// [6003]
    /// ParameterName=Preset value
    /// AccessType=ro
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6003]
    /// ParameterName=Preset value
    /// AccessType=rw
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, chapter 8, Access; CANchkEDS V30
    pub(crate) WrongEncoderAccess { code: "ENC006", level: Level::Warn, since: "0.1.0" }
}

impl EncoderRule for WrongEncoderAccess {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        for value in encoder.values(|spans| spans.access).filter(EncoderValue::is_given) {
            if let Some((fact, cure)) = contradiction(&value) {
                report.at(value.at, format!("{} {fact}", value.named())).help(cure);
            }
        }
    }
}

fn contradiction(value: &EncoderValue<'_>) -> Option<(&'static str, &'static str)> {
    match (value.standard.access, value.entry.access.writable()) {
        (Access::ReadOnly, true) => Some((
            "can be written; CiA 406 has it read only",
            "write `AccessType=ro`, or `const` if it never changes",
        )),
        (Access::Writable, false) => Some(("cannot be written; CiA 406 has it rw", "write `AccessType=rw`")),
        _ => None,
    }
}
