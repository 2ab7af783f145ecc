use super::mapped::{all_mapped, label};
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds PDOs that map an object or a sub-index which the file does not describe.
    ///
    /// ## Why it matters
    /// Nobody knows what is in the PDO: a master cannot name the value, a generator has nothing to send.
    ///
    /// ## Example
    /// ```ini
    /// [1A00sub1]
    /// DefaultValue=0x60000208
    ///
    /// [6000]
    /// SubNumber=2
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1A00sub1]
    /// DefaultValue=0x60000108
    /// ```
    ///
    /// ## Reference
    /// CiA 301, object 1600h; CANchkEDS V63
    pub(crate) AbsentMappedObject { code: "PDO004", level: Level::Deny, since: "0.1.0" }
}

impl DictionaryRule for AbsentMappedObject {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for mapped in all_mapped(dictionary).filter(|mapped| mapped.dummy().is_none()) {
            if dictionary.entry(mapped.address).is_none() {
                let (pdo, address) = (label(&mapped.pdo), mapped.address);
                report
                    .at(
                        mapped.span,
                        format!("{pdo} maps {address}, which the file does not have"),
                    )
                    .help(format!("describe {address}, or map another object"));
            }
        }
    }
}
