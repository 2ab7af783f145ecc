use super::standard::standard;
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects from 1000h to 1FFFh that neither CiA 301 nor CiA 302 nor EN 50325-5 defines.
    ///
    /// ## Why it matters
    /// That area is for the standards. A vendor's object there will mean something else one day, and tools that go by the index treat
    /// it as part of the communication: they do not save it, or reset it with the communication.
    ///
    /// ## Example
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=1
    /// 1=0x1100
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [ManufacturerObjects]
    /// SupportedObjects=1
    /// 1=0x2100
    /// ```
    ///
    /// ## Reference
    /// CiA 301, structure of the object dictionary
    pub(crate) UnknownCommunicationObject { code: "COM012", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for UnknownCommunicationObject {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        let communication = dictionary
            .objects
            .iter()
            .filter(|object| (0x1000..0x2000).contains(&object.index));
        for object in communication.filter(|object| standard(object.index).is_none()) {
            let index = object.index;
            report
                .at(
                    object.span,
                    format!("{index:04X}h is kept for the standards, and none defines it"),
                )
                .help("move the object to 2000h to 5FFFh");
        }
    }
}
