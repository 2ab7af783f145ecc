use super::standard::standard;
use crate::{
    diagnostic::Level,
    ir::{Dictionary, Entry},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds sub-indices of communication objects beyond those that the standard defines: 1018sub5, 1800sub7. One finding for an object.
    ///
    /// ## Why it matters
    /// A later version of the standard may give the sub-index a meaning; tools that know the object do not show or save the value.
    ///
    /// ## Example
    /// ```ini
    /// [1018sub5]
    /// ParameterName=Build number
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [2000]
    /// ParameterName=Build number
    /// ```
    ///
    /// ## Reference
    /// CiA 301 and CiA 302, objects 1000h to 1FFFh; CANchkEDS V38
    pub(crate) UnknownStandardSubIndex { code: "COM009", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for UnknownStandardSubIndex {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for object in &dictionary.objects {
            let Some(standard) = standard(object.index).filter(|standard| standard.is_like(object.code)) else {
                continue;
            };
            // Sub-index 255 is the structure of the object.
            let unknown = |entry: &&Entry| entry.address.sub > standard.highest && entry.address.sub != u8::MAX;
            if let Some(entry) = object.entries.iter().find(unknown) {
                let (address, name, highest) = (entry.address, standard.name, standard.highest);
                report
                    .at(
                        entry.spans.section,
                        format!("{address} is no part of {name}, whose highest sub-index is {highest}"),
                    )
                    .help("move it to an object of its own, from 2000h on");
            }
        }
    }
}
