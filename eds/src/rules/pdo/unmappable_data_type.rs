use super::mapped::{all_mapped, label};
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds PDOs that map an object without fixed length: a string or a domain.
    ///
    /// ## Why it matters
    /// Where the next object starts in the frame depends on a length that nobody knows.
    ///
    /// ## Example
    /// ```ini
    /// [1A00sub1]
    /// DefaultValue=0x10080040
    ///
    /// [1008]
    /// DataType=0x0009
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1A00sub1]
    /// DefaultValue=0x60040020
    /// ```
    ///
    /// ## Reference
    /// CiA 301, object 1600h; CANchkEDS V66
    pub(crate) UnmappableDataType { code: "PDO009", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for UnmappableDataType {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for mapped in all_mapped(dictionary).filter(|mapped| mapped.dummy().is_none()) {
            let entry = dictionary.entry(mapped.address);
            let Some(entry) = entry.filter(|entry| entry.data_type.bits().is_none()) else {
                continue;
            };
            let (pdo, address, name) = (label(&mapped.pdo), mapped.address, entry.data_type.name());
            report
                .at(
                    mapped.span,
                    format!("{pdo} maps {address}, a {name}, which has no fixed length"),
                )
                .related(entry.spans.data_type, "its data type")
                .help("map a number");
        }
    }
}
