use super::Encoder;
use crate::{
    diagnostic::Level,
    ir::Address,
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds cams and work areas whose low limit lies above their high limit after power-on, and encoders whose least position (650Ah:02)
    /// lies above their greatest (650Ah:03).
    ///
    /// ## Why it matters
    /// No position lies between them: the cam is never active, the work area always left.
    ///
    /// ## Example
    /// ```ini
    /// [6401sub1]
    /// ParameterName=Work area low limit
    /// DefaultValue=8000
    ///
    /// [6402sub1]
    /// ParameterName=Work area high limit
    /// DefaultValue=1000
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6401sub1]
    /// ParameterName=Work area low limit
    /// DefaultValue=1000
    ///
    /// [6402sub1]
    /// ParameterName=Work area high limit
    /// DefaultValue=8000
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, 8.2, 8.3 and 8.4.11
    pub(crate) InvertedSwitchPoints { code: "ENC013", level: Level::Warn, since: "0.1.0" }
}

impl EncoderRule for InvertedSwitchPoints {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        let cams = (0x6310..0x6318).map(|low| (low, low + 0x10));
        let pairs = cams.chain([(0x6401, 0x6402)]);
        for (low, high) in pairs.filter(|(low, high)| encoder.has(*low) && encoder.has(*high)) {
            for channel in 1..=254 {
                check_pair(encoder, Address::new(low, channel), Address::new(high, channel), report);
            }
        }
        check_pair(encoder, Address::new(0x650A, 2), Address::new(0x650A, 3), report);
    }
}

fn check_pair(encoder: &Encoder<'_>, low: Address, high: Address, report: &mut Report) {
    let (Some(least), Some(most)) = (encoder.number_at(low), encoder.number_at(high)) else {
        return;
    };
    if least.value > most.value {
        report
            .at(
                least.span,
                format!("{low} is {}, above {high}, which is {}", least.value, most.value),
            )
            .related(most.span, "the high limit")
            .help("exchange them");
    }
}
