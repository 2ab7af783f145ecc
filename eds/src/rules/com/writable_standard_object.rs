use super::standard::{Access, field, standard};
use crate::{
    diagnostic::Level,
    ir::{Dictionary, Entry},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds communication objects that say what the device is and how it is, but that the file makes writable: 1000h, 1001h, 1008h,
    /// 1018h and others, the errors in 1003h, the COB-IDs of 1200h, and sub-index 0 where it is the number of sub-indices. One
    /// finding for an object.
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
    /// CiA 301 and CiA 302, objects 1000h to 1FFFh; CANchkEDS V30
    pub(crate) WritableStandardObject { code: "COM006", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for WritableStandardObject {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for object in &dictionary.objects {
            // Of an object of another kind it is COM005.
            let Some(standard) = standard(object.index).filter(|standard| standard.is_like(object.code)) else {
                continue;
            };
            let reads = |entry: &&Entry| field(entry.address).is_some_and(|field| field.access == Access::Read);
            let mut writable = object.entries.iter().filter(|entry| entry.access.writable());
            if let Some(entry) = writable.find(reads) {
                let (address, access, name) = (entry.address, entry.access.name(), standard.name);
                report
                    .at(entry.spans.access, format!("{address} of {name} is {access}"))
                    .help("write `const`, or `ro` if the device changes it");
            }
        }
    }
}
