use crate::{
    Reading,
    diagnostic::Level,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds a BaudRate_xxx for a bit rate that CiA 301 does not have: it has 10, 20, 50, 125, 250, 500, 800 and 1000 kbit/s.
    ///
    /// ## Why it matters
    /// Tools offer the bit rates of the standard; LSS has no number for another one.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// BaudRate_100=1
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceInfo]
    /// BaudRate_125=1
    /// ```
    ///
    /// ## Reference
    /// CiA 301, 6.2, bit rates; CiA 305, table selector 0
    pub(crate) UnknownBitRate { code: "DEV008", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for UnknownBitRate {
    fn check(reading: &Reading, report: &mut Report) {
        let rates = reading.eds.device_info.iter().flat_map(|device| &device.baud_rates);
        for rate in rates.filter(|rate| !KNOWN.contains(&rate.rate)) {
            report
                .at(rate.key, format!("CiA 301 has no bit rate of {} kbit/s", rate.rate))
                .help("remove the line, or write one of 10, 20, 50, 125, 250, 500, 800, 1000");
        }
    }
}

/// In kbit/s.
const KNOWN: [u16; 8] = [10, 20, 50, 125, 250, 500, 800, 1000];
