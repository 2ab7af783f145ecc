use super::{
    mapped::{all_mapped, label},
    wrong_direction::opposite,
};
use crate::{
    diagnostic::Level,
    ir::{AccessType, Dictionary, Direction},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds RPDOs that map an object with access type rwr, and TPDOs that map one with rww.
    ///
    /// ## Why it matters
    /// The r or w at the end says the direction in a PDO: rwr is read by a TPDO, rww is written by an RPDO. A tool that goes by it
    /// does not offer the object for the PDO that already has it.
    ///
    /// ## Example
    /// ```ini
    /// [1600sub1]
    /// DefaultValue=0x62000108
    ///
    /// [6200sub1]
    /// AccessType=rwr
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
    /// CiA 306-1, AccessType; CANchkEDS V8
    pub(crate) ContraryDirection { code: "PDO023", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for ContraryDirection {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for mapped in all_mapped(dictionary) {
            let direction = mapped.pdo.direction;
            let (contrary, fitting) = match direction {
                Direction::Receive => (AccessType::Rwr, "rww"),
                Direction::Transmit => (AccessType::Rww, "rwr"),
            };
            let entry = dictionary.entry(mapped.address);
            if let Some(entry) = entry.filter(|entry| entry.access == contrary) {
                let (pdo, address, access) = (label(&mapped.pdo), mapped.address, contrary.name());
                report
                    .at(mapped.span, format!("{pdo} maps {address}, which is {access}"))
                    .related(entry.spans.access, "its access type")
                    .help(format!("write `{fitting}`, or map it in {}", opposite(direction)));
            }
        }
    }
}
