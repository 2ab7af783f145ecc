use super::mapped::{all_mapped, label};
use crate::{
    diagnostic::Level,
    ir::{Dictionary, Direction},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds TPDOs that map a data type in place of an object.
    ///
    /// ## Why it matters
    /// A dummy skips bits that others sent. In a PDO that the device itself sends there is no value to put there.
    ///
    /// ## Example
    /// ```ini
    /// [1A00sub1]
    /// DefaultValue=0x00050008
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1A00sub1]
    /// DefaultValue=0x60000108
    /// ```
    ///
    /// ## Reference
    /// CiA 301, dummy mapping; CANchkEDS V74
    pub(crate) DummyInTpdo { code: "PDO013", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for DummyInTpdo {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        let sent = all_mapped(dictionary).filter(|mapped| mapped.pdo.direction == Direction::Transmit);
        for mapped in sent {
            if let Some(data_type) = mapped.dummy() {
                let (pdo, name) = (label(&mapped.pdo), data_type.name());
                report
                    .at(mapped.span, format!("{pdo} maps a dummy {name}; only RPDOs may"))
                    .help("map an object");
            }
        }
    }
}
