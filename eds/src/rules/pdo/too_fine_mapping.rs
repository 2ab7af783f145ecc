use super::mapped::{all_mapped, label};
use crate::{
    diagnostic::Level,
    ir::Dictionary,
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds mapping entries shorter than Granularity.
    ///
    /// ## Why it matters
    /// Granularity is the least length that can be mapped: the file shows a mapping that it rules out.
    ///
    /// ## Example
    /// ```ini
    /// [DeviceInfo]
    /// Granularity=16
    ///
    /// [1A00sub1]
    /// DefaultValue=0x60000108
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DeviceInfo]
    /// Granularity=8
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, Granularity; CANchkEDS V75
    pub(crate) TooFineMapping { code: "PDO017", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for TooFineMapping {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        let granularity = dictionary.device.granularity;
        for mapped in all_mapped(dictionary).filter(|mapped| mapped.bits < granularity) {
            let (pdo, address, bits) = (label(&mapped.pdo), mapped.address, mapped.bits);
            report
                .at(
                    mapped.span,
                    format!("{pdo} maps {bits} bits of {address}; Granularity is {granularity}"),
                )
                .help(format!("write `Granularity={bits}`, or map a longer object"));
        }
    }
}
