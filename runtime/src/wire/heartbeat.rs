//! Boot-up and heartbeat (CiA 301, 7.2.8.3.2.2 and 7.2.8.3.3): CAN-ID 700h + node-ID, one byte.

use super::{nmt::NmtState, CanId, Frame};
use crate::NodeId;

/// The frame in which `node_id` tells its state: `704#7F` from node 4 in PRE-OPERATIONAL. From INITIALISING it is the
/// boot-up message, `704#00`.
#[must_use]
pub const fn emit(node_id: NodeId, state: NmtState) -> Frame {
    Frame::byte(CanId::error_control(node_id), state.number())
}

/// Who tells which state in `frame`; `None` when it is not a heartbeat.
///
/// Bit 7 toggles in answers to node guarding (7.2.8.3.2.1) and is ignored.
#[must_use]
pub fn parse(frame: &Frame) -> Option<(NodeId, NmtState)> {
    let node = frame
        .data_id()
        .filter(|id| !id.is_extended())?
        .number()
        .checked_sub(0x700)?;
    let &[byte] = frame.data() else { return None };
    Some((
        NodeId::new(u8::try_from(node).ok()?)?,
        NmtState::from_number(byte & 0x7F)?,
    ))
}

#[cfg(test)]
mod tests {
    use super::{emit, parse};
    use crate::{wire::nmt::NmtState, NodeId};

    #[test]
    fn what_is_emitted_is_parsed_again() {
        for state in [
            NmtState::Initialising,
            NmtState::Stopped,
            NmtState::Operational,
            NmtState::PreOperational,
        ] {
            let node_id = NodeId::new(127).unwrap();
            assert_eq!(parse(&emit(node_id, state)), Some((node_id, state)));
        }
    }
}
