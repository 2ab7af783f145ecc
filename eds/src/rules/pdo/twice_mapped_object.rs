use std::collections::BTreeMap;

use super::mapped::{label, mapped, pdos};
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds PDOs that map an object twice.
    ///
    /// ## Why it matters
    /// In a TPDO the bytes are there twice; in an RPDO the second value overwrites the first. Mostly another object was meant.
    ///
    /// ## Example
    /// ```ini
    /// [1A00sub1]
    /// DefaultValue=0x60000108
    /// [1A00sub2]
    /// DefaultValue=0x60000108
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1A00sub2]
    /// DefaultValue=0x60000208
    /// ```
    ///
    /// ## Reference
    /// CiA 301, objects 1600h and 1A00h
    pub(crate) TwiceMappedObject { code: "PDO025", level: Level::Note, since: "0.1.0" }
}

impl DictionaryRule for TwiceMappedObject {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for pdo in pdos(dictionary) {
            let mut places = BTreeMap::new();
            for mapped in mapped(pdo).filter(|mapped| mapped.dummy().is_none()) {
                if let Some(first) = places.insert(mapped.address, mapped.span) {
                    let (pdo, address) = (label(&mapped.pdo), mapped.address);
                    report
                        .at(mapped.span, format!("{pdo} maps {address} twice"))
                        .related(first, "the first time")
                        .help("map another object, or take it out");
                }
            }
        }
    }
}
