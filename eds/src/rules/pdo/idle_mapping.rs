use super::mapped::{is_variable, label, pdos};
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds PDOs whose mapping can be written, but not their COB-ID.
    ///
    /// ## Why it matters
    /// A mapping may be changed only while the PDO is switched off, and what switches it off is bit 31 of the COB-ID.
    ///
    /// ## Example
    /// ```ini
    /// [1800sub1]
    /// AccessType=const
    ///
    /// [1A00sub0]
    /// AccessType=rw
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1800sub1]
    /// AccessType=rw
    /// ```
    ///
    /// ## Reference
    /// CiA 301, object 1600h; CANchkEDS W26
    pub(crate) IdleMapping { code: "PDO022", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for IdleMapping {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for pdo in pdos(dictionary).filter(|pdo| is_variable(*pdo) == Some(true)) {
            let cob_id = pdo.communication.and_then(|object| object.entry(1));
            if let Some(cob_id) = cob_id.filter(|cob_id| !cob_id.access.writable()) {
                let (pdo, access) = (label(&pdo), cob_id.access.name());
                report
                    .at(
                        cob_id.spans.access,
                        format!("the COB-ID of {pdo} is {access}, but its mapping can be written"),
                    )
                    .help("write `rw`, or make the mapping constant");
            }
        }
    }
}
