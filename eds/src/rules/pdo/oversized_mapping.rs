use super::mapped::{label, mapped, pdos};
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds PDOs whose mapped objects add up to more than 64 bits.
    ///
    /// ## Why it matters
    /// A classic CAN frame carries eight bytes. The device must refuse such a mapping with abort code 0604 0042h, so the PDO can
    /// never be enabled.
    ///
    /// ## Example
    /// ```ini
    /// [1A00sub0]
    /// DefaultValue=3
    /// [1A00sub1]
    /// DefaultValue=0x60640020
    /// [1A00sub2]
    /// DefaultValue=0x606C0020
    /// [1A00sub3]
    /// DefaultValue=0x60FD0020
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1A00sub0]
    /// DefaultValue=2
    /// ```
    ///
    /// ## Reference
    /// CiA 301, object 1600h; CANchkEDS V64
    pub(crate) OversizedMapping { code: "PDO001", level: Level::Deny, since: "0.1.0" }
}

/// What a classic CAN frame carries.
const MOST_BITS: u32 = 64;

impl DictionaryRule for OversizedMapping {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for pdo in pdos(dictionary) {
            let bits: u32 = mapped(pdo).map(|mapped| u32::from(mapped.bits)).sum();
            let Some(last) = mapped(pdo).last().filter(|_| bits > MOST_BITS) else {
                continue;
            };
            report
                .at(
                    last.span,
                    format!("{} maps {bits} bits; a frame carries 64", label(&pdo)),
                )
                .label("the last of them")
                .help("move an object to another PDO");
        }
    }
}
