use super::Encoder;
use crate::{
    diagnostic::Level,
    ir::Address,
    rules::{EncoderRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds encoders whose cyclic timer (6200h) and event timer of TPDO 1 (1800h:05) differ after power-on.
    ///
    /// ## Why it matters
    /// From CiA 406 V3.0 on they are one timer under two addresses: a device in which they differ has either two timers, or a file that
    /// gives one of them wrong. V2.0 knows 6200h only, so it is a note.
    ///
    /// ## Example
    /// ```ini
    /// [1800sub5]
    /// ParameterName=Event timer
    /// DefaultValue=0
    ///
    /// [6200]
    /// ParameterName=Cyclic timer
    /// DefaultValue=10
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1800sub5]
    /// ParameterName=Event timer
    /// DefaultValue=10
    /// ```
    ///
    /// ## Reference
    /// CiA 406 V2.0, 8.1.10; V3.0, history
    pub(crate) DividedCycle { code: "ENC019", level: Level::Note, since: "0.1.0" }
}

impl EncoderRule for DividedCycle {
    fn check(encoder: &Encoder<'_>, report: &mut Report) {
        let event_timer = encoder.number_at(Address::new(0x1800, 5));
        let (Some(cyclic_timer), Some(event_timer)) = (encoder.number(0x6200), event_timer) else {
            return;
        };
        if cyclic_timer.value != event_timer.value {
            let fact = format!(
                "6200h is {} ms, 1800sub5 is {} ms",
                cyclic_timer.value, event_timer.value
            );
            report
                .at(cyclic_timer.span, fact)
                .related(event_timer.span, "the event timer of TPDO 1")
                .help("give both the same period");
        }
    }
}
