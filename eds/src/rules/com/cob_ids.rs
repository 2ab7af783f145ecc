//! The COB-IDs of the services that the dictionary configures.

use crate::ir::{Dictionary, Direction, Entry, Value};

/// The service does not exist: bit 31 of its COB-ID.
const INVALID: u64 = 1 << 31;
/// The CAN-ID has 29 bits: bit 29 of the COB-ID.
const EXTENDED: u64 = 1 << 29;

/// A CAN-ID of 11 bits, as the file gives it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct CanId {
    /// Without the node-ID, if it is a formula.
    pub(super) base: u16,
    /// Whether the node-ID is added.
    pub(super) with_node_id: bool,
}

/// A service that sends or receives under a CAN-ID of its own.
pub(super) struct Service<'a> {
    /// How a message calls it: `TPDO 1`.
    pub(super) name: String,
    /// Whether the device sends under the CAN-ID.
    pub(super) sends: bool,
    pub(super) can_id: CanId,
    pub(super) entry: &'a Entry,
}

/// The services that exist after power-on and whose CAN-ID has 11 bits.
pub(super) fn services(dictionary: &Dictionary) -> Vec<Service<'_>> {
    let single = |index: u16| dictionary.object(index)?.entry(0);
    let mut candidates = vec![
        ("SYNC".to_owned(), true, single(0x1005)),
        ("TIME".to_owned(), true, single(0x1012)),
        ("EMCY".to_owned(), true, single(0x1014)),
    ];
    for (direction, kind) in [(Direction::Receive, "RPDO"), (Direction::Transmit, "TPDO")] {
        candidates.extend(dictionary.pdos(direction).map(|pdo| {
            let entry = pdo.communication.and_then(|object| object.entry(1));
            (
                format!("{kind} {}", pdo.number),
                direction == Direction::Transmit,
                entry,
            )
        }));
    }
    let known = candidates.into_iter();
    known
        .filter_map(|(name, sends, entry)| {
            let entry = entry?;
            let can_id = can_id(entry.default.as_ref()?)?;
            Some(Service {
                name,
                sends,
                can_id,
                entry,
            })
        })
        .collect()
}

fn can_id(value: &Value) -> Option<CanId> {
    let (cob_id, with_node_id) = match *value {
        Value::Unsigned(cob_id) => (cob_id, false),
        Value::NodeIdPlus(cob_id) => (cob_id, true),
        _ => return None,
    };
    let base = u16::try_from(cob_id & 0x7FF).ok()?;
    let exists = cob_id & (INVALID | EXTENDED) == 0;
    exists.then_some(CanId { base, with_node_id })
}
