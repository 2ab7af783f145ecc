use super::mapped::{is_variable, pdos};
use crate::{
    Reading,
    diagnostic::Level,
    fix::Fix,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds a Granularity above 0 in a device whose PDO mappings are all constant.
    ///
    /// ## Why it matters
    /// Granularity is the step in which a mapping can be changed; 0 says that none can. A tool offers to edit what the device
    /// refuses.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// Granularity=8
    ///
    /// [1A00sub0]
    /// AccessType=const
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceInfo]
    /// Granularity=0
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, Granularity; CANchkEDS V69
    pub(crate) NeedlessGranularity { code: "PDO015", level: Level::Note, since: "0.1.0", fixable: Always }
}

impl ReadingRule for NeedlessGranularity {
    fn check(reading: &Reading, report: &mut Report) {
        let granularity = reading.eds.device_info.as_ref().and_then(|info| info.granularity);
        let Some(granularity) = granularity.filter(|granularity| granularity.value > 0) else {
            return;
        };
        let mut variable = pdos(&reading.dictionary).filter_map(is_variable).peekable();
        if variable.peek().is_some() && variable.all(|variable| !variable) {
            let (value, bare) = (granularity.value, report.bare(granularity.span));
            report
                .at(
                    granularity.span,
                    format!("Granularity is {value}, but no PDO mapping can be changed"),
                )
                .help("write `Granularity=0`")
                .fix(Fix::replace(bare, "0"));
        }
    }
}
