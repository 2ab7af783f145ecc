//! NMT (CiA 301, 7.2.8.3.1): commands with CAN-ID 000h, two bytes, from the master to one node or to all; and the states
//! that they lead to.

use super::{CanId, Frame};
use crate::NodeId;

/// A node's NMT state. Its number is what a heartbeat carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum NmtState {
    /// Before the boot-up message, and again after a reset: no service answers. In a heartbeat 00h: the boot-up message.
    Initialising,
    /// 04h: only NMT and error control.
    Stopped,
    /// 05h: all services.
    Operational,
    /// 7Fh: all services but PDO.
    PreOperational,
}

impl NmtState {
    /// The state with this number in a heartbeat; `None` for one that CiA 301 does not define.
    #[must_use]
    pub const fn from_number(number: u8) -> Option<Self> {
        match number {
            0x00 => Some(Self::Initialising),
            0x04 => Some(Self::Stopped),
            0x05 => Some(Self::Operational),
            0x7F => Some(Self::PreOperational),
            _ => None,
        }
    }

    /// The number in a heartbeat.
    #[must_use]
    pub const fn number(self) -> u8 {
        match self {
            Self::Initialising => 0x00,
            Self::Stopped => 0x04,
            Self::Operational => 0x05,
            Self::PreOperational => 0x7F,
        }
    }
}

/// What the master orders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum NmtCommand {
    /// 01h: go OPERATIONAL.
    Start,
    /// 02h: go STOPPED.
    Stop,
    /// 80h: go PRE-OPERATIONAL.
    EnterPreOperational,
    /// 81h: reset node.
    ResetNode,
    /// 82h: reset communication.
    ResetCommunication,
}

impl NmtCommand {
    /// The command with this number; `None` for one that CiA 301 does not define.
    #[must_use]
    pub const fn from_number(number: u8) -> Option<Self> {
        match number {
            0x01 => Some(Self::Start),
            0x02 => Some(Self::Stop),
            0x80 => Some(Self::EnterPreOperational),
            0x81 => Some(Self::ResetNode),
            0x82 => Some(Self::ResetCommunication),
            _ => None,
        }
    }

    /// The command's number.
    #[must_use]
    pub const fn number(self) -> u8 {
        match self {
            Self::Start => 0x01,
            Self::Stop => 0x02,
            Self::EnterPreOperational => 0x80,
            Self::ResetNode => 0x81,
            Self::ResetCommunication => 0x82,
        }
    }
}

/// Who is to obey.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Recipient {
    /// 0: all nodes.
    All,
    /// 1 to 127: one node.
    One(NodeId),
}

impl Recipient {
    /// Whether `node_id` is among them.
    #[must_use]
    pub fn includes(self, node_id: NodeId) -> bool {
        match self {
            Self::All => true,
            Self::One(one) => one == node_id,
        }
    }
}

/// A command and who is to obey it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Request {
    /// The order.
    pub command: NmtCommand,
    /// Who is to obey.
    pub recipient: Recipient,
}

impl Request {
    /// Start, to all nodes: `000#0100`.
    pub const START_ALL: Self = Self {
        command: NmtCommand::Start,
        recipient: Recipient::All,
    };

    /// The data of a frame with CAN-ID 000h. `None` for an unknown command, a node above 127, and fewer than two bytes;
    /// bytes beyond the second mean nothing.
    #[must_use]
    pub fn parse(data: &[u8]) -> Option<Self> {
        let &[command, node, ..] = data else { return None };
        let recipient = match node {
            0 => Recipient::All,
            node => Recipient::One(NodeId::new(node)?),
        };
        Some(Self {
            command: NmtCommand::from_number(command)?,
            recipient,
        })
    }

    /// The frame: `000#0104` starts node 4.
    #[must_use]
    pub fn emit(self) -> Option<Frame> {
        let node = match self.recipient {
            Recipient::All => 0,
            Recipient::One(node_id) => node_id.get(),
        };
        Frame::new(CanId::NMT, &[self.command.number(), node])
    }
}

#[cfg(test)]
mod tests {
    use super::{NmtCommand, Recipient, Request};
    use crate::NodeId;

    #[test]
    fn a_command_has_two_bytes_a_known_number_and_a_node_up_to_127() {
        assert_eq!(Request::parse(&[0x01]), None);
        assert_eq!(Request::parse(&[0x55, 4]), None);
        assert_eq!(Request::parse(&[0x01, 128]), None);
        let request = Request::parse(&[0x81, 127]).unwrap();
        assert_eq!(request.command, NmtCommand::ResetNode);
        assert_eq!(request.recipient, Recipient::One(NodeId::new(127).unwrap()));
    }

    #[test]
    fn what_is_emitted_is_parsed_again() {
        for number in 0..=0xFF {
            for node in 0..=0xFF {
                if let Some(request) = Request::parse(&[number, node]) {
                    assert_eq!(request.emit().unwrap().data(), [number, node]);
                }
            }
        }
    }
}
