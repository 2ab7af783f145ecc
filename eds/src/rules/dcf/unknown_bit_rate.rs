use super::bit_rates::BIT_RATES;
use crate::{
    diagnostic::Level,
    model::Eds,
    rules::{ModelRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds a Baudrate in `[DeviceComissioning]` that is none of CANopen's: 10, 20, 50, 125, 250, 500, 800 and 1000 kbit/s.
    ///
    /// ## Why it matters
    /// A node cannot be set to it over LSS, and tools refuse it. Often it is given in bit/s.
    ///
    /// 100 kbit/s, which older devices know, is not among them any more.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceComissioning]
    /// NodeID=5
    /// Baudrate=38400
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceComissioning]
    /// NodeID=5
    /// Baudrate=500
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, 5.3; CiA 301, 5.4; CiA 305, table of bit timings
    pub(crate) UnknownBitRate { code: "DCF006", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for UnknownBitRate {
    fn check(eds: &Eds, report: &mut Report) {
        let rate = eds.commissioning.as_ref().and_then(|section| section.baud_rate);
        if let Some(rate) = rate.filter(|rate| !BIT_RATES.contains(&rate.value)) {
            let value = report.quote(rate.span);
            report
                .at(
                    rate.span,
                    format!("Baudrate is {value}, which is no bit rate of CANopen"),
                )
                .help("give it in kbit/s: 10, 20, 50, 125, 250, 500, 800 or 1000");
        }
    }
}
