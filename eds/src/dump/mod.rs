//! What a device answered when its object dictionary was read over SDO.
//!
//! A dump holds bytes, not meaning: which data type they are of is the EDS's word, and the rules of family DMP compare
//! the two. An address that a dump does not hold was not asked for.

mod abort;
mod answer;
mod identity;
#[cfg(feature = "json")]
mod json;

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

pub use abort::AbortCode;
pub use answer::Answer;
pub use identity::Identity;
#[cfg(feature = "json")]
pub use json::JsonError;

use crate::ir::{Address, NodeId};

/// One device, read once.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Dump {
    /// The node that answered.
    pub node_id: NodeId,
    /// When, as RFC 3339 writes it (`2026-11-23T04:17:00Z`); `None` where there was no clock.
    pub taken: Option<String>,
    /// What the device said it is when the dump began; `None` when it was not asked.
    ///
    /// The same facts stand in [`Dump::objects`]. Two that disagree tell of a dump that was continued on another device.
    pub device: Option<Identity>,
    /// Every address that was asked for, with the answer.
    pub objects: BTreeMap<Address, Answer>,
}

impl Dump {
    /// A dump of `node_id` that nothing was asked for yet.
    #[must_use]
    pub const fn new(node_id: NodeId) -> Self {
        Self {
            node_id,
            taken: None,
            device: None,
            objects: BTreeMap::new(),
        }
    }

    /// The answer at `address`; `None` when it was not asked for.
    #[must_use]
    pub fn answer(&self, address: Address) -> Option<&Answer> {
        self.objects.get(&address)
    }

    /// The bytes that were read at `address`, little-endian for numbers; `None` when there is no answer or another one.
    #[must_use]
    pub fn value(&self, address: Address) -> Option<&[u8]> {
        self.answer(address)?.value()
    }

    /// The answers of the object at `index`, by sub-index.
    #[must_use]
    pub fn object(&self, index: u16) -> impl DoubleEndedIterator<Item = (Address, &Answer)> {
        self.objects
            .range(sub_indices(index))
            .map(|(address, answer)| (*address, answer))
    }
}

const fn sub_indices(index: u16) -> RangeInclusive<Address> {
    Address::new(index, 0)..=Address::new(index, 0xFF)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_object_is_its_own_sub_indices_only() {
        let mut dump = Dump::new(NodeId::new(5).unwrap());
        for (index, sub) in [(0x1017, 0xFF), (0x1018, 0), (0x1018, 0xFF), (0x1019, 0)] {
            dump.objects.insert(Address::new(index, sub), Answer::Timeout);
        }
        let subs: Vec<u8> = dump.object(0x1018).map(|(address, _)| address.sub).collect();
        assert_eq!(subs, [0, 0xFF]);
    }
}
