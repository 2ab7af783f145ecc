use crate::{
    Reading,
    diagnostic::Level,
    ir::DataType,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds data types in `[DummyUsage]` that cannot fill a place in a PDO: they have no fixed length, or CiA 301 does not define them.
    ///
    /// ## Why it matters
    /// A dummy stands for as many bits as its type has. Tools that offer it make a mapping that the device refuses.
    ///
    /// ## Example
    /// ```ini
    /// [DummyUsage]
    /// Dummy0009=1
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DummyUsage]
    /// Dummy0005=1
    /// ```
    ///
    /// ## Reference
    /// CiA 301, dummy mapping; CiA 306-1, `[DummyUsage]`
    pub(crate) StrangeDummy { code: "PDO028", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for StrangeDummy {
    fn check(reading: &Reading, report: &mut Report) {
        let usage = reading.eds.dummy_usage.iter().flat_map(|usage| &usage.types);
        for dummy in usage.filter(|dummy| dummy.used.value) {
            let data_type = DataType::from_index(dummy.data_type);
            if data_type.and_then(DataType::bits).is_none() {
                let index = dummy.data_type;
                let what = data_type.map_or("no data type of CiA 301", DataType::name);
                report
                    .at(
                        dummy.key,
                        format!("{index:04X}h is {what}, which cannot fill a place in a PDO"),
                    )
                    .help("write 0, or remove the line");
            }
        }
    }
}
