//! Flash or RAM.

use lexican_eds::ir::{AccessType, Entry, Object, Value};

use super::Options;
use crate::selector::is_count;

/// Where a value stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Storage {
    /// In the struct, in RAM.
    Field,
    /// In flash: nobody ever changes it.
    Constant,
    /// Nowhere in the dictionary: a DOMAIN or string of any length, which the application gives and takes in parts.
    Parts,
}

impl Storage {
    /// Where the value of `entry` stands; `handled` when the application answers for it.
    pub(crate) fn of(object: &Object, entry: &Entry, handled: bool, options: &Options) -> Self {
        if options.in_parts(object, entry, handled) {
            return Self::Parts;
        }
        // Without a value in the file it is the application that gives it, even to a const object.
        let known = matches!(&entry.default, Some(value) if !matches!(value, Value::NodeIdPlus(_)));
        if known && !handled && never_changes(object, entry) {
            Self::Constant
        } else {
            Self::Field
        }
    }
}

/// Whether neither a client nor the application changes the value.
fn never_changes(object: &Object, entry: &Entry) -> bool {
    match entry.access {
        _ if is_serial_number(entry) => false,
        AccessType::Const => true,
        AccessType::Ro => is_count(object, entry) || is_identity(entry),
        _ => false,
    }
}

/// 1018h:04: of one device, while the file is about all of a kind.
fn is_serial_number(entry: &Entry) -> bool {
    (entry.address.index, entry.address.sub) == (0x1018, 4)
}

/// What the file says of all devices of a kind: device type, names and versions, vendor, product and revision
/// (CiA 301, 7.5.2.1, 7.5.2.9 to 7.5.2.11, 7.5.2.19). The standard has them constant; many files say ro.
fn is_identity(entry: &Entry) -> bool {
    matches!(
        (entry.address.index, entry.address.sub),
        (0x1000 | 0x1008..=0x100A, 0) | (0x1018, 1..=3)
    )
}
