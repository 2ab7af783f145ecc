use std::collections::BTreeSet;

use super::mapped::all_mapped;
use crate::{
    diagnostic::Level,
    ir::{AccessType, Address, Dictionary, Entry},
    rules::{DictionaryRule, Report, declare_rule, more},
};

declare_rule! {
    /// ## What it does
    /// Finds mappable objects with access type rw that are in no PDO: whether a TPDO reads them or an RPDO writes them is not
    /// said. One finding for a file; SARIF and JSON name all the places.
    ///
    /// ## Why it matters
    /// Tools that connect the PDOs of devices offer the object for both directions. For a process input there is rwr, for an
    /// output rww.
    ///
    /// ## Example
    /// ```ini
    /// [6200sub1]
    /// ParameterName=Write outputs 1 to 8
    /// AccessType=rw
    /// PDOMapping=1
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [6200sub1]
    /// ParameterName=Write outputs 1 to 8
    /// AccessType=rww
    /// PDOMapping=1
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, AccessType; CANchkEDS W4. Of an object that is in a PDO it is PDO007.
    pub(crate) UndirectedObject { code: "PDO006", level: Level::Note, since: "0.1.0" }
}

impl DictionaryRule for UndirectedObject {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        let mapped: BTreeSet<Address> = all_mapped(dictionary).map(|mapped| mapped.address).collect();
        let mut undirected: Vec<&Entry> = dictionary.entries().filter(|entry| is_undirected(entry)).collect();
        undirected.retain(|entry| !mapped.contains(&entry.address));
        // In the compact form one line stands for many.
        undirected.dedup_by_key(|entry| entry.spans.access);
        // An editor that does not know rwr and rww writes all objects so: one finding, with all the places.
        if let Some((first, others)) = undirected.split_first() {
            let (address, more) = (first.address, more(others.len()));
            let finding = report.at(
                first.spans.access,
                format!("{address} may be mapped, but rw gives it no direction{more}"),
            );
            finding.help("write `rwr` for a TPDO, `rww` for an RPDO");
            for other in others {
                finding.related(other.spans.access, other.address.to_string());
            }
        }
    }
}

/// Whether it may be mapped in either direction.
pub(super) fn is_undirected(entry: &Entry) -> bool {
    entry.pdo_mapping && entry.access == AccessType::Rw
}
