use super::standard::{field, standard};
use crate::{
    diagnostic::Level,
    ir::{Dictionary, Entry},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds PDOMapping=1 of communication objects that no PDO may carry: all but 1001h, 1002h, 1013h, 1026h, and the COB-IDs of SDOs.
    /// One finding for an object.
    ///
    /// ## Why it matters
    /// Tools offer the object for a PDO. Settings of the communication, such as a COB-ID, would change while it runs.
    ///
    /// ## Example
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// PDOMapping=1
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1017]
    /// ParameterName=Producer heartbeat time
    /// PDOMapping=0
    /// ```
    ///
    /// ## Reference
    /// CiA 301, objects 1000h to 1FFFh, PDO mapping; CANchkEDS V30
    pub(crate) MappableStandardObject { code: "COM011", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for MappableStandardObject {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for object in &dictionary.objects {
            let unmappable = |entry: &&Entry| field(entry.address).is_some_and(|field| !field.mappable);
            let mappable = object.entries.iter().filter(|entry| entry.pdo_mapping);
            if let Some(entry) = mappable.into_iter().find(unmappable) {
                let (address, name) = (
                    entry.address,
                    standard(object.index).map_or("", |standard| standard.name),
                );
                report
                    .at(
                        entry.spans.pdo_mapping,
                        format!("{address} of {name} has PDOMapping=1, but no PDO may carry it"),
                    )
                    .help("write `PDOMapping=0`");
            }
        }
    }
}
