use super::mapped::{count, label, pdos};
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds multiplexed PDOs, whose mapping has 254 or 255 at sub-index 0, in a device without GroupMessaging=1.
    ///
    /// ## Why it matters
    /// GroupMessaging says that the device has multiplexed PDOs: a tool that looks there takes the number for a count.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// GroupMessaging=0
    ///
    /// [1A00sub0]
    /// DefaultValue=255
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceInfo]
    /// GroupMessaging=1
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, GroupMessaging; CiA 301, multiplexed PDO; CANchkEDS V73
    pub(crate) UngroupedMultiplexedPdo { code: "PDO020", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for UngroupedMultiplexedPdo {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        if dictionary.device.group_messaging {
            return;
        }
        for pdo in pdos(dictionary) {
            let multiplexed = count(pdo).filter(|count| *count >= 254);
            let sub_zero = pdo.mapping.and_then(|mapping| mapping.entry(0));
            if let Some((count, entry)) = multiplexed.zip(sub_zero) {
                report
                    .at(
                        entry.spans.default,
                        format!(
                            "{count} makes {} a multiplexed PDO, but GroupMessaging is not 1",
                            label(&pdo)
                        ),
                    )
                    .help("write `GroupMessaging=1` in [DeviceInfo]");
            }
        }
    }
}
