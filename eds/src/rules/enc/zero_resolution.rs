use super::Encoder;
use crate::{
    diagnostic::Level,
    ir::Address,
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds 0 as units per revolution (6001h), measuring range (6002h), single-turn resolution or measuring step (6501h), number of
    /// revolutions (6502h), or measuring step of a linear encoder (6005h:01).
    ///
    /// ## Why it matters
    /// A master divides by it to get angle or length.
    ///
    /// ## Example
    /// ```ini
    /// [6501]
    /// ParameterName=Single-turn resolution
    /// DefaultValue=0
    /// ```
    ///
    /// Use instead, if it differs from one encoder to the next:
    /// ```ini
    /// [6501]
    /// ParameterName=Single-turn resolution
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, 8.1.2, 8.1.3, 8.1.6, 8.4.2 and 8.4.3
    pub(crate) ZeroResolution { code: "ENC016", level: Level::Warn, since: "0.1.0" }
}

impl EncoderRule for ZeroResolution {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        let single = [0x6001, 0x6002, 0x6501, 0x6502].map(|index| Address::new(index, 0));
        for address in single.into_iter().chain([Address::new(0x6005, 1)]) {
            if let Some(number) = encoder.number_at(address).filter(|number| number.value == 0) {
                let named = match address.sub {
                    0 => format!("{:04X}h", address.index),
                    _ => address.to_string(),
                };
                report
                    .at(number.span, format!("{named} is 0; nothing can be measured by that"))
                    .help("give the encoder's value, or no DefaultValue if each encoder has its own");
            }
        }
    }
}
