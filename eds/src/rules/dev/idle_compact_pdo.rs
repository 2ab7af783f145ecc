use crate::{
    Reading,
    diagnostic::Level,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds CompactPDO in a device whose NrOfRXPDO and NrOfTXPDO are 0 or missing.
    ///
    /// ## Why it matters
    /// CompactPDO stands for as many communication and mapping parameters as these two say: for none.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// NrOfTXPDO=0
    /// CompactPDO=0x03
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceInfo]
    /// NrOfTXPDO=4
    /// CompactPDO=0x03
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, CompactPDO; CANchkEDS W50
    pub(crate) IdleCompactPdo { code: "DEV010", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for IdleCompactPdo {
    fn check(reading: &Reading, report: &mut Report) {
        let Some(device) = &reading.eds.device_info else { return };
        let has_none = [device.nr_of_rx_pdo, device.nr_of_tx_pdo]
            .into_iter()
            .flatten()
            .all(|number| number.value == 0);
        let compact = device.compact_pdo.filter(|compact| compact.value > 0 && has_none);
        if let Some(compact) = compact {
            report
                .at(compact.span, "CompactPDO is set, but NrOfRXPDO and NrOfTXPDO are 0")
                .help("write the number of PDOs, or `CompactPDO=0`");
        }
    }
}
