use super::mapped::{MOST_ENTRIES, count, label, pdos};
use crate::{
    diagnostic::Level,
    ir::{Dictionary, Object, Pdo},
    rules::{DictionaryRule, Report, declare_rule},
    span::Span,
};

declare_rule! {
    /// ## What it does
    /// Finds PDO mappings that lack a sub-index between 1 and their highest, or up to the number that sub-index 0 gives.
    ///
    /// ## Why it matters
    /// Mapping entries are used one after the other: a master that reads them gets an abort at the gap.
    ///
    /// ## Example
    /// ```ini
    /// [1A00sub0]
    /// DefaultValue=2
    /// [1A00sub1]
    /// DefaultValue=0x60000108
    /// [1A00sub3]
    /// DefaultValue=0x60000208
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1A00sub0]
    /// DefaultValue=2
    /// [1A00sub1]
    /// DefaultValue=0x60000108
    /// [1A00sub2]
    /// DefaultValue=0x60000208
    /// ```
    ///
    /// ## Reference
    /// CiA 301, object 1600h; CANchkEDS V11
    pub(crate) MappingGap { code: "PDO010", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for MappingGap {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for pdo in pdos(dictionary) {
            if let Some((missing, at)) = pdo.mapping.and_then(|mapping| gap(pdo, mapping)) {
                report
                    .at(at, format!("{} has no mapping entry {missing}", label(&pdo)))
                    .help("describe it, or renumber those behind it and fix sub-index 0");
            }
        }
    }
}

/// The first mapping entry that is missing, and where one sees that it should be there.
fn gap(pdo: Pdo<'_>, mapping: &Object) -> Option<(u8, Span)> {
    let highest = mapping.entries.iter().map(|entry| entry.address.sub).max()?;
    let counted = count(pdo).filter(|count| *count <= MOST_ENTRIES).unwrap_or(0);
    let missing = (1..=highest.max(counted)).find(|sub| mapping.entry(*sub).is_none())?;
    let following = mapping.entries.iter().find(|entry| entry.address.sub > missing);
    let sub_zero = mapping.entry(0)?.spans.default;
    Some((missing, following.map_or(sub_zero, |entry| entry.spans.section)))
}
