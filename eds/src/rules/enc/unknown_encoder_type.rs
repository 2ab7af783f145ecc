use super::Encoder;
use crate::{
    diagnostic::Level,
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds encoders whose device type has an encoder type, the high word of 1000h, that CiA 406 does not define: it knows 1 to 10.
    ///
    /// ## Why it matters
    /// A master learns from it whether positions are angles or lengths, of one turn or of many, of one sensor or of several.
    ///
    /// ## Example
    /// ```ini
    /// [1000]
    /// ParameterName=Device type
    /// DefaultValue=0x00000196
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1000]
    /// ParameterName=Device type
    /// DefaultValue=0x00020196
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, 7.4, object 1000h
    pub(crate) UnknownEncoderType { code: "ENC001", level: Level::Warn, since: "0.1.0" }
}

impl EncoderRule for UnknownEncoderType {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        let Some(encoder_type) = encoder.encoder_type else {
            return;
        };
        if !(1..=10).contains(&encoder_type.code) {
            report
                .at(
                    encoder_type.span,
                    format!("encoder type {} is none of CiA 406", encoder_type.code),
                )
                .help("give the high word 1 (single-turn), 2 (multi-turn), 8 (absolute linear) or another of CiA 406");
        }
    }
}
