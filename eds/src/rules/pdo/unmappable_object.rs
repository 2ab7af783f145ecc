use super::mapped::{all_mapped, label};
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds PDOs that map an object without PDOMapping=1.
    ///
    /// ## Why it matters
    /// The file says of one object that it cannot be mapped and that it is. A master that checks PDOMapping refuses to configure
    /// the PDO as the device already has it.
    ///
    /// ## Example
    /// ```ini
    /// [1A00sub1]
    /// DefaultValue=0x60000108
    ///
    /// [6000sub1]
    /// PDOMapping=0
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6000sub1]
    /// PDOMapping=1
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, PDOMapping; CANchkEDS V35
    pub(crate) UnmappableObject { code: "PDO002", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for UnmappableObject {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for mapped in all_mapped(dictionary).filter(|mapped| mapped.dummy().is_none()) {
            let Some(entry) = dictionary.entry(mapped.address).filter(|entry| !entry.pdo_mapping) else {
                continue;
            };
            let (pdo, address) = (label(&mapped.pdo), mapped.address);
            report
                .at(mapped.span, format!("{pdo} maps {address}, which has no PDOMapping=1"))
                .related(entry.spans.pdo_mapping, "the mapped object")
                .help(format!("write `PDOMapping=1` in {address}, or map another object"));
        }
    }
}
