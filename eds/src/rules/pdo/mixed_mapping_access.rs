use super::mapped::{label, pdos};
use crate::{
    diagnostic::Level,
    ir::{Dictionary, Entry, Object},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds PDO mappings of which sub-index 0 can be written and the entries cannot, or the other way round.
    ///
    /// ## Why it matters
    /// A mapping is changed by writing 0 to sub-index 0, then the entries, then their number. Where one of these is constant
    /// the other is of no use.
    ///
    /// ## Example
    /// ```ini
    /// [1A00sub0]
    /// AccessType=const
    /// [1A00sub1]
    /// AccessType=rw
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1A00sub0]
    /// AccessType=const
    /// [1A00sub1]
    /// AccessType=const
    /// ```
    ///
    /// ## Reference
    /// CiA 301, object 1600h; CANchkEDS V67, V68
    pub(crate) MixedMappingAccess { code: "PDO012", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for MixedMappingAccess {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for pdo in pdos(dictionary) {
            let Some((zero, other)) = pdo.mapping.and_then(mixed) else {
                continue;
            };
            let (pdo, access) = (label(&pdo), zero.access.name());
            let (address, of_other) = (other.address, other.access.name());
            report
                .at(
                    other.spans.access,
                    format!("mapping entry {address} of {pdo} is {of_other}, sub-index 0 is {access}"),
                )
                .related(zero.spans.access, "sub-index 0")
                .help("make all of the mapping writable, or none");
        }
    }
}

/// Sub-index 0, and the first entry of another kind.
fn mixed(mapping: &Object) -> Option<(&Entry, &Entry)> {
    let zero = mapping.entry(0)?;
    let others = mapping.entries.iter().skip(1);
    let mut mixed = others.filter(|entry| entry.access.writable() != zero.access.writable());
    Some((zero, mixed.next()?))
}
