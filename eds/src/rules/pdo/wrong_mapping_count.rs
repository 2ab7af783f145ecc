use super::mapped::{MOST_ENTRIES, count, label, pdos};
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds PDO mappings whose sub-index 0 is from 65 to 253: more objects than a PDO can have, and no multiplexed PDO.
    ///
    /// ## Why it matters
    /// The value is reserved; a device refuses it, and a master that reads so many entries gets aborts.
    ///
    /// ## Example
    /// ```ini
    /// [1A00sub0]
    /// DefaultValue=65
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1A00sub0]
    /// DefaultValue=1
    /// ```
    ///
    /// ## Reference
    /// CiA 301, object 1600h
    pub(crate) WrongMappingCount { code: "PDO021", level: Level::Deny, since: "0.1.0" }
}

impl DictionaryRule for WrongMappingCount {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for pdo in pdos(dictionary) {
            let reserved = count(pdo).filter(|count| (MOST_ENTRIES + 1..254).contains(count));
            let sub_zero = pdo.mapping.and_then(|mapping| mapping.entry(0));
            if let Some((count, entry)) = reserved.zip(sub_zero) {
                report
                    .at(
                        entry.spans.default,
                        format!("{} maps {count} objects; at most 64 go into a PDO", label(&pdo)),
                    )
                    .help("write how many entries are mapped");
            }
        }
    }
}
