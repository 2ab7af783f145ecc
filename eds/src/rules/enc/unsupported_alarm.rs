use super::Encoder;
use crate::{
    diagnostic::Level,
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds alarms (6503h) and warnings (6505h) that are set after power-on, though the encoder says in 6504h or 6506h that it does not
    /// support them.
    ///
    /// ## Why it matters
    /// A master looks only at the alarms that are supported: this one it overlooks, or takes for a defect.
    ///
    /// ## Example
    /// ```ini
    /// [6503]
    /// ParameterName=Alarms
    /// DefaultValue=0x0002
    ///
    /// [6504]
    /// ParameterName=Supported alarms
    /// DefaultValue=0x0001
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6503]
    /// ParameterName=Alarms
    /// DefaultValue=0x0000
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, 8.4.4 to 8.4.7
    pub(crate) UnsupportedAlarm { code: "ENC009", level: Level::Warn, since: "0.1.0" }
}

impl EncoderRule for UnsupportedAlarm {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        for (index, supported) in [(0x6503, 0x6504), (0x6505, 0x6506)] {
            let (Some(found), Some(all)) = (encoder.number(index), encoder.number(supported)) else {
                continue;
            };
            if let Some(bit) = (0..16).find(|bit| found.value & !all.value & 1 << bit != 0) {
                let fact = format!("{index:04X}h has bit {bit} set, which {supported:04X}h does not support");
                report
                    .at(found.span, fact)
                    .related(all.span, "the supported ones")
                    .help(format!("clear the bit, or set it in {supported:04X}h"));
            }
        }
    }
}
