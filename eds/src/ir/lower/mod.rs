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
        let mut lowering = Lowering::new();
        let lower = |object| object::lower(object, &mut lowering);
        let mut objects: Vec<_> = eds.objects.iter().filter_map(lower).collect();
        compact_pdo::add(eds, &mut objects);
        module::compose(eds, &mut objects, &mut lowering);
        objects.sort_by_key(|object| object.index);
        list::assign(eds, &mut objects, &mut lowering);
        list::report_unlisted(eds, &objects, &mut lowering);
        let dictionary = Self {
            file: device::file(eds),
            device: device::device(eds),
            commissioning: device::commissioning(eds),
            dummies: device::dummies(eds),
            objects,
        };
        (dictionary, lowering.problems)
    }
}

/// What is kept from object to object.
struct Lowering {
    problems: Vec<Problem>,
    /// How many more values without sections there may be.
    room: usize,
}

impl Lowering {
    const fn new() -> Self {
        Self {
            problems: Vec::new(),
            room: MOST_UNDESCRIBED,
        }
    }

    fn report(&mut self, problem: Problem) {
        self.problems.push(problem);
    }

    /// Takes room for `count` values that have no section of their own; `false` when there is none.
    fn take_room(&mut self, count: usize) -> bool {
        let left = self.room.checked_sub(count);
        self.room = left.unwrap_or(self.room);
        left.is_some()
    }
}

/// The most values without sections of their own. A line of text can stand for 254 of them, so that a file of a few
/// megabytes could ask for more memory than there is. No device has that many.
const MOST_UNDESCRIBED: usize = 500_000;
