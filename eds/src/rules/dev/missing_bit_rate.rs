use crate::{
    Reading,
    diagnostic::Level,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds devices that know no bit rate: no BaudRate_xxx is 1, and BaudRate_auto is not either.
    ///
    /// ## Why it matters
    /// A tool that sets up the network looks for a bit rate that all its devices know, and finds none.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// BaudRate_125=0
    /// BaudRate_500=0
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceInfo]
    /// BaudRate_125=1
    /// BaudRate_500=1
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, BaudRate_xxx; CiA 301, 6.2, bit rates
    pub(crate) MissingBitRate { code: "DEV007", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for MissingBitRate {
    fn check(reading: &Reading, report: &mut Report) {
        let Some(device) = &reading.eds.device_info else { return };
        let adapts = device.baud_rate_auto.is_some_and(|adapts| adapts.value);
        if !adapts && !device.baud_rates.iter().any(|rate| rate.supported.value) {
            report
                .at(device.header, "the device knows no bit rate")
                .help("write `BaudRate_125=1`, or whatever it knows, in this section");
        }
    }
}
