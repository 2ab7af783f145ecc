use super::{
    mapped::{all_mapped, label},
    undirected_object::is_undirected,
};
use crate::{
    diagnostic::Level,
    ir::{Dictionary, Direction},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds objects with access type rw that are in a PDO.
    ///
    /// ## Why it matters
    /// The direction is known, and the file does not say it: a tool may offer the object for the other one as well.
    ///
    /// ## Example
    /// ```ini
    /// [1600sub1]
    /// DefaultValue=0x62000108
    ///
    /// [6200sub1]
    /// AccessType=rw
    /// PDOMapping=1
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6200sub1]
    /// AccessType=rww
    /// PDOMapping=1
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, AccessType; CANchkEDS W4 and W5
    pub(crate) UndirectedMappedObject { code: "PDO007", level: Level::Note, since: "0.1.0" }
}

impl DictionaryRule for UndirectedMappedObject {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for mapped in all_mapped(dictionary) {
            let entry = dictionary.entry(mapped.address);
            let Some(entry) = entry.filter(|entry| is_undirected(entry)) else {
                continue;
            };
            let (pdo, address) = (label(&mapped.pdo), mapped.address);
            let access = match mapped.pdo.direction {
                Direction::Receive => "rww",
                Direction::Transmit => "rwr",
            };
            report
                .at(
                    entry.spans.access,
                    format!("{address} is in {pdo}, but rw gives it no direction"),
                )
                .related(mapped.span, format!("mapped by {}", mapped.place))
                .help(format!("write `{access}`"));
        }
    }
}
