use crate::{
    Reading,
    diagnostic::Level,
    ir::DataType,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds data types that `[DummyUsage]` allows as dummies, though they are shorter than Granularity.
    ///
    /// ## Why it matters
    /// Granularity is the least length that can be mapped: such a dummy can never be.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// Granularity=8
    ///
    /// [DummyUsage]
    /// Dummy0001=1
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DummyUsage]
    /// Dummy0001=0
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, Granularity and `[DummyUsage]`; CANchkEDS V76
    pub(crate) TooFineDummy { code: "PDO018", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for TooFineDummy {
    fn check(reading: &Reading, report: &mut Report) {
        let granularity = reading.dictionary.device.granularity;
        let usage = reading.eds.dummy_usage.iter().flat_map(|usage| &usage.types);
        for dummy in usage.filter(|dummy| dummy.used.value) {
            let data_type = DataType::from_index(dummy.data_type);
            let bits = data_type.and_then(DataType::bits).filter(|bits| *bits < granularity);
            if let (Some(data_type), Some(bits)) = (data_type, bits) {
                let name = data_type.name();
                report
                    .at(
                        dummy.used.span,
                        format!("a dummy {name} has {bits} bits; Granularity is {granularity}"),
                    )
                    .help("write 0, or lower the Granularity");
            }
        }
    }
}
