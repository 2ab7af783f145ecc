use super::mapped::{all_mapped, kind, label};
use crate::{
    diagnostic::Level,
    ir::{AccessType, Dictionary, Direction},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds RPDOs that map an object which cannot be written (ro, const), and TPDOs that map one which cannot be read (wo).
    ///
    /// ## Why it matters
    /// A value that cannot be written arrives and is lost, or one that cannot be read is to be sent.
    ///
    /// ## Example
    /// ```ini
    /// [1600sub1]
    /// DefaultValue=0x60000108
    ///
    /// [6000sub1]
    /// AccessType=ro
    /// PDOMapping=1
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1A00sub1]
    /// DefaultValue=0x60000108
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, AccessType; CANchkEDS V8. Of rwr and rww it is PDO023.
    pub(crate) WrongDirection { code: "PDO005", level: Level::Deny, since: "0.1.0" }
}

impl DictionaryRule for WrongDirection {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        for mapped in all_mapped(dictionary).filter(|mapped| mapped.dummy().is_none()) {
            let Some(entry) = dictionary.entry(mapped.address) else {
                continue;
            };
            let direction = mapped.pdo.direction;
            if goes(entry.access, direction) {
                continue;
            }
            let (pdo, address, access) = (label(&mapped.pdo), mapped.address, entry.access.name());
            report
                .at(mapped.span, format!("{pdo} maps {address}, which is {access}"))
                .related(entry.spans.access, "its access type")
                .help(format!("map it in {}, or fix the AccessType", opposite(direction)));
        }
    }
}

const fn goes(access: AccessType, direction: Direction) -> bool {
    match direction {
        Direction::Receive => access.writable(),
        Direction::Transmit => access.readable(),
    }
}

/// A PDO of the other direction, for a cure.
pub(super) fn opposite(direction: Direction) -> String {
    let other = match direction {
        Direction::Receive => Direction::Transmit,
        Direction::Transmit => Direction::Receive,
    };
    let article = if other == Direction::Receive { "an" } else { "a" };
    format!("{article} {}", kind(other))
}
