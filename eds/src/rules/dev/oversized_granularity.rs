use crate::{
    Reading,
    diagnostic::Level,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds a Granularity above 64.
    ///
    /// ## Why it matters
    /// It is the least number of bits that can be mapped. A PDO has 64, so that nothing could be mapped at all.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// Granularity=80
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceInfo]
    /// Granularity=8
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, Granularity
    pub(crate) OversizedGranularity { code: "DEV006", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for OversizedGranularity {
    fn check(reading: &Reading, report: &mut Report) {
        let device = reading.eds.device_info.as_ref();
        let stated = device
            .and_then(|device| device.granularity)
            .filter(|bits| bits.value > 64);
        if let Some(bits) = stated {
            report
                .at(bits.span, format!("Granularity is {}; a PDO has 64 bits", bits.value))
                .help("write 8 for whole bytes, 1 for single bits, 0 if no mapping can be changed");
        }
    }
}
