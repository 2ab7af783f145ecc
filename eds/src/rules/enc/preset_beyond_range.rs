use super::Encoder;
use crate::{
    diagnostic::Level,
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds preset values (6003h) after power-on that lie outside of the measuring range (6002h).
    ///
    /// ## Why it matters
    /// Positions go from 0 to one below the range: the encoder never stands at its preset, and refuses it when a master writes it back.
    ///
    /// ## Example
    /// ```ini
    /// [6002]
    /// DefaultValue=4096
    ///
    /// [6003]
    /// DefaultValue=4096
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6003]
    /// DefaultValue=4095
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, 8.1.3 and 8.1.4
    pub(crate) PresetBeyondRange { code: "ENC017", level: Level::Warn, since: "0.1.0" }
}

impl EncoderRule for PresetBeyondRange {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        let (Some(range), Some(preset)) = (encoder.number(0x6002), encoder.number(0x6003)) else {
            return;
        };
        // What is 0 is ENC016.
        if range.value > 0 && preset.value >= range.value {
            let (value, most) = (preset.value, range.value - 1);
            report
                .at(
                    preset.span,
                    format!("preset {value} lies outside of the positions, 0 to {most}"),
                )
                .related(range.span, "the measuring range")
                .help(format!("give at most {most}"));
        }
    }
}
