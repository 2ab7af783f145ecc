use crate::{
    Reading,
    diagnostic::Level,
    ir::Address,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds LSS_Supported=1 in a device without one of vendor-ID, product code, revision number and serial number (1018h:1 to 4).
    ///
    /// ## Why it matters
    /// These four are the LSS address. A device that lacks one cannot be told from its neighbours, so it never gets a node-ID.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// LSS_Supported=1
    ///
    /// [1018]
    /// SubNumber=2
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1018]
    /// SubNumber=5
    /// ```
    ///
    /// ## Reference
    /// CiA 305, LSS address; CiA 301, object 1018h
    pub(crate) IncompleteLssAddress { code: "DEV005", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for IncompleteLssAddress {
    fn check(reading: &Reading, report: &mut Report) {
        let device = reading.eds.device_info.as_ref();
        let supported = device.and_then(|device| device.lss_supported).filter(|lss| lss.value);
        let Some(supported) = supported else { return };
        let has = |sub: &u8| reading.dictionary.entry(Address::new(0x1018, *sub)).is_some();
        if let Some(missing) = (1..=4).find(|sub| !has(sub)) {
            report
                .at(
                    supported.span,
                    format!("LSS_Supported is 1, but 1018sub{missing} is missing"),
                )
                .help(format!("describe 1018sub{missing}, or write `LSS_Supported=0`"));
        }
    }
}
