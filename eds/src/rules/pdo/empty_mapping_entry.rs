use super::mapped::{counted, label, pdos, unsigned};
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds mapping entries that sub-index 0 counts, but that are 0.
    ///
    /// ## Why it matters
    /// 0 maps nothing, and there is no such place in a frame: the device refuses the number in sub-index 0 when it is written
    /// back, with abort code 0602 0000h.
    ///
    /// ## Example
    /// ```ini
    /// [1A00sub0]
    /// DefaultValue=2
    /// [1A00sub1]
    /// DefaultValue=0x60000108
    /// [1A00sub2]
    /// DefaultValue=0
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1A00sub0]
    /// DefaultValue=1
    /// ```
    ///
    /// ## Reference
    /// CiA 301, object 1600h; CANchkEDS W51
    pub(crate) EmptyMappingEntry { code: "PDO011", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for EmptyMappingEntry {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for pdo in pdos(dictionary) {
            // One for each PDO: what follows the first is of the same kind.
            let mut empty = counted(pdo).filter(|entry| unsigned(entry.default.as_ref()) == Some(0));
            if let Some(entry) = empty.next() {
                let address = entry.address;
                report
                    .at(
                        entry.spans.default,
                        format!("{} counts {address}, which maps nothing", label(&pdo)),
                    )
                    .help(format!(
                        "map an object, or write `DefaultValue={}` in sub-index 0",
                        address.sub - 1
                    ));
            }
        }
    }
}
