//! From what the file says to what the device is.
//!
//! | what the file leaves out | what the dictionary has |
//! |---|---|
//! | ObjectType | VAR; ARRAY with CompactSubObj, RECORD with sub-objects |
//! | DataType of sub-index 0 | UNSIGNED8 |
//! | DataType, AccessType of another sub-index | those of the object |
//! | DataType of a DOMAIN | DOMAIN |
//! | DataType otherwise | DOMAIN: nothing is known of the bytes |
//! | AccessType of a DOMAIN | `rw` |
//! | AccessType otherwise | `ro`: nothing can be broken |
//! | PDOMapping | not mappable |
//! | sub-index 0 of an ARRAY or RECORD | the highest sub-index, `ro` |
//! | a PDO's objects, with CompactPDO | as CompactPDO says |
//!
//! What CiA 306-1 does not allow to be left out is a [`Problem`] as well.

mod compact;
mod compact_pdo;
mod device;
mod entry;
mod list;
mod module;
mod object;
mod problem;

pub use problem::Problem;

use super::Dictionary;
use crate::model::Eds;

impl Dictionary {
    /// What the device is that a file describes, and what had to be made up or left out.
    #[must_use]
    pub fn lower(eds: &Eds) -> (Self, Vec<Problem>) {
        let mut problems = Vec::new();
        let mut objects: Vec<_> = eds
            .objects
            .iter()
            .map(|object| object::lower(object, &mut problems))
            .collect();
        compact_pdo::add(eds, &mut objects);
        module::compose(eds, &mut objects, &mut problems);
        objects.sort_by_key(|object| object.index);
        list::assign(eds, &mut objects, &mut problems);
        list::report_unlisted(eds, &objects, &mut problems);
        let dictionary = Self {
            file: device::file(eds),
            device: device::device(eds),
            commissioning: device::commissioning(eds),
            dummies: device::dummies(eds),
            objects,
        };
        (dictionary, problems)
    }
}
