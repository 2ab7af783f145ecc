use crate::{
    Reading,
    diagnostic::Level,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds devices with `[SupportedModules]` but without object 1027h, module list, and the other way round.
    ///
    /// ## Why it matters
    /// 1027h says on the bus which modules are plugged in, `[SupportedModules]` what each of them is. A master needs both to know the
    /// dictionary of the device.
    ///
    /// ## Example
    /// ```ini
    /// [SupportedModules]
    /// NrOfEntries=1
    ///
    /// [M1ModuleInfo]
    /// ProductName=Amplifier
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=1
    /// 1=0x1027
    ///
    /// [SupportedModules]
    /// NrOfEntries=1
    ///
    /// [M1ModuleInfo]
    /// ProductName=Amplifier
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, modules; CiA 301, object 1027h; CANchkEDS V54, V55
    pub(crate) HalfAModuleList { code: "DEV011", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for HalfAModuleList {
    fn check(reading: &Reading, report: &mut Report) {
        let supported = reading.eds.supported_modules.as_ref();
        let supported = supported.filter(|modules| modules.count.is_none_or(|count| count.value > 0));
        match (supported, reading.dictionary.object(0x1027)) {
            (Some(modules), None) => {
                report
                    .at(modules.header, "modules are supported, but object 1027h is missing")
                    .help("describe object 1027h, module list");
            }
            (None, Some(object)) => {
                report
                    .at(object.span, "object 1027h is here, but [SupportedModules] is missing")
                    .help("write [SupportedModules] and a section [MxModuleInfo] for each kind of module");
            }
            _ => {}
        }
    }
}
