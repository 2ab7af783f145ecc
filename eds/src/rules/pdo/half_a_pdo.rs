use super::mapped::{label, pdos};
use crate::{
    diagnostic::Level,
    ir::{Dictionary, Object, Pdo},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds PDOs of which only one of the two objects is there: the communication parameter (1400h, 1800h …) or the mapping
    /// parameter (1600h, 1A00h …, at a distance of 200h).
    ///
    /// ## Why it matters
    /// Without the first nobody knows when and under which COB-ID the PDO comes, without the second what is in it.
    ///
    /// ## Example
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=1
    /// 1=0x1800
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [OptionalObjects]
    /// SupportedObjects=2
    /// 1=0x1800
    /// 2=0x1A00
    /// ```
    ///
    /// ## Reference
    /// CiA 301, objects 1400h to 1BFFh
    pub(crate) HalfAPdo { code: "PDO003", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for HalfAPdo {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for pdo in pdos(dictionary) {
            if let Some((there, missing)) = half(&pdo) {
                let (pdo, index) = (label(&pdo), there.index);
                report
                    .at(there.span, format!("{pdo} has {index:04X}h, but not {missing:04X}h"))
                    .help(format!("describe object {missing:04X}h, or remove {index:04X}h"));
            }
        }
    }
}

/// The object that is there, and the index of the one that is not.
fn half<'a>(pdo: &Pdo<'a>) -> Option<(&'a Object, u16)> {
    const DISTANCE: u16 = 0x200;
    match (pdo.communication, pdo.mapping) {
        (Some(communication), None) => Some((communication, communication.index + DISTANCE)),
        (None, Some(mapping)) => Some((mapping, mapping.index - DISTANCE)),
        _ => None,
    }
}
