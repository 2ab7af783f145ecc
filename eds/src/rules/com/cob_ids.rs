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
    /// Its CAN-ID in the predefined connection set, if it is in there.
    pub(super) predefined: Option<CanId>,
    pub(super) can_id: CanId,
    pub(super) entry: &'a Entry,
}

impl Service<'_> {
    /// Whether all devices of the kind have the CAN-ID of one node.
    pub(super) fn is_fixed(&self) -> bool {
        let predefined = self.predefined.filter(|predefined| predefined.with_node_id);
        let of_some_node = |predefined: CanId| (predefined.base..=predefined.base + 127).contains(&self.can_id.base);
        !self.entry.configured && !self.can_id.with_node_id && predefined.is_some_and(of_some_node)
    }
}

/// The services that exist after power-on and whose CAN-ID has 11 bits.
pub(super) fn services(dictionary: &Dictionary) -> Vec<Service<'_>> {
    let mut services = Vec::new();
    for (index, name, base, with_node_id) in [
        (0x1005, "SYNC", 0x80, false),
        (0x1012, "TIME", 0x100, false),
        (0x1014, "EMCY", 0x80, true),
    ] {
        let entry = dictionary.object(index).and_then(|object| object.entry(0));
        let predefined = Some(CanId { base, with_node_id });
        services.extend(service(name.to_owned(), true, predefined, entry));
    }
    for (direction, kind, first) in [
        (Direction::Receive, "RPDO", 0x200),
        (Direction::Transmit, "TPDO", 0x180),
    ] {
        services.extend(dictionary.pdos(direction).filter_map(|pdo| {
            let entry = pdo.communication.and_then(|object| object.entry(1));
            let name = format!("{kind} {}", pdo.number);
            let predefined = (pdo.number <= 4).then(|| CanId {
                base: first + 0x100 * (pdo.number - 1),
                with_node_id: true,
            });
            service(name, direction == Direction::Transmit, predefined, entry)
        }));
    }
    services
}

fn service(name: String, sends: bool, predefined: Option<CanId>, entry: Option<&Entry>) -> Option<Service<'_>> {
    let entry = entry?;
    Some(Service {
        name,
        sends,
        predefined,
        can_id: can_id(entry.default.as_ref()?)?,
        entry,
    })
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
