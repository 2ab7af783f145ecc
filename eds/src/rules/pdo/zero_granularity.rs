use super::mapped::{is_variable, pdos};
use crate::{
    Reading,
    diagnostic::Level,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds a Granularity of 0 in a device whose PDO mappings can all be changed.
    ///
    /// ## Why it matters
    /// 0 says that no mapping can be changed: a tool that believes it does not let the user change one.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// Granularity=0
    ///
    /// [1A00sub0]
    /// AccessType=rw
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceInfo]
    /// Granularity=8
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, Granularity; CANchkEDS V70
    pub(crate) ZeroGranularity { code: "PDO016", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for ZeroGranularity {
    fn check(reading: &Reading, report: &mut Report) {
        let granularity = reading.eds.device_info.as_ref().and_then(|info| info.granularity);
        let Some(granularity) = granularity.filter(|granularity| granularity.value == 0) else {
            return;
        };
        let mut variable = pdos(&reading.dictionary).filter_map(is_variable).peekable();
        if variable.peek().is_some() && variable.all(|variable| variable) {
            report
                .at(
                    granularity.span,
                    "Granularity is 0, but all PDO mappings can be changed",
                )
                .help("write the least length that can be mapped, such as `Granularity=8`");
        }
    }
}
