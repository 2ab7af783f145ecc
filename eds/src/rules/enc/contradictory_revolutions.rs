use super::Encoder;
use crate::{
    diagnostic::Level,
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds single-turn encoders (encoder type 1) with another number of revolutions in 6502h than 1, and multi-turn encoders (type 2)
    /// with 1.
    ///
    /// ## Why it matters
    /// A master that goes by the device type and one that goes by 6502h take the same position for different places.
    ///
    /// ## Example
    /// ```ini
    /// [1000]
    /// DefaultValue=0x00010196
    ///
    /// [6502]
    /// ParameterName=Number of distinguishable revolutions
    /// DefaultValue=4096
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1000]
    /// DefaultValue=0x00020196
    ///
    /// [6502]
    /// ParameterName=Number of distinguishable revolutions
    /// DefaultValue=4096
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, 7.4, object 1000h, and 8.4.3
    pub(crate) ContradictoryRevolutions { code: "ENC015", level: Level::Warn, since: "0.1.0" }
}

impl EncoderRule for ContradictoryRevolutions {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        let (Some(encoder_type), Some(turns)) = (encoder.encoder_type, encoder.number(0x6502)) else {
            return;
        };
        // What is 0 is ENC016.
        let fact = match (encoder_type.code, turns.value) {
            (1, 2..) => "single-turn",
            (2, 1) => "multi-turn",
            _ => return,
        };
        report
            .at(
                turns.span,
                format!("6502h is {}, but 1000h makes it a {fact} encoder", turns.value),
            )
            .related(encoder_type.span, "the device type")
            .help("give the encoder type 1 (single-turn) or 2 (multi-turn) to 1000h, or fix 6502h");
    }
}
