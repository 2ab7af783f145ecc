use super::standard::standard;
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects that say what the device is and how it is, but that the file makes writable: 1000h, 1001h, 1002h, 1008h, 1009h,
    /// 100Ah and 1018h.
    ///
    /// ## Why it matters
    /// A tool that restores all writable parameters writes them: the device refuses, or becomes another one.
    ///
    /// ## Example
    /// ```ini
    /// [1000]
    /// ParameterName=Device type
    /// AccessType=rw
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1000]
    /// ParameterName=Device type
    /// AccessType=const
    /// ```
    ///
    /// ## Reference
    /// CiA 301, objects 1000h to 1018h; CANchkEDS V30
    pub(crate) WritableStandardObject { code: "COM006", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for WritableStandardObject {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for entry in dictionary.entries().filter(|entry| entry.access.writable()) {
            let address = entry.address;
            if let Some(standard) = standard(address.index).filter(|standard| standard.read_only) {
                let (access, name) = (entry.access.name(), standard.name);
                report
                    .at(entry.spans.access, format!("{address} of {name} is {access}"))
                    .help("write `const`, or `ro` if the device changes it");
            }
        }
    }
}
