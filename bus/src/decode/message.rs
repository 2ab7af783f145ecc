//! What a frame says.

use lexican_eds::ir::Value;
use lexican_runtime::{
    Address, NodeId,
    od::TimeOfDay,
    wire::{
        emcy::Emergency,
        lss,
        nmt::{self, NmtState},
    },
};

use super::{Described, Direction, Ended, Field, Outcome, Step, value};

/// A frame in the standard's words.
#[derive(Clone, Debug, PartialEq)]
pub enum Message<'a> {
    /// The NMT master's order.
    Nmt(nmt::Request),
    /// SYNC, with its counter if it has one.
    Sync(Option<u8>),
    /// TIME.
    Time(TimeOfDay),
    /// EMCY.
    Emergency {
        /// Who.
        node_id: NodeId,
        /// What.
        emergency: Emergency,
        /// The error code in words.
        meaning: &'static str,
    },
    /// A node has started.
    BootUp(NodeId),
    /// A heartbeat, or the answer to node guarding.
    Heartbeat {
        /// Who.
        node_id: NodeId,
        /// Its state.
        state: NmtState,
        /// Alternates in answers to node guarding; never set in a heartbeat.
        toggle: bool,
    },
    /// The master asks for the node's state by a remote frame.
    Guarding(NodeId),
    /// SDO.
    Sdo(Exchange<'a>),
    /// A PDO.
    Pdo(Received<'a>),
    /// A PDO that says which object it carries.
    Multiplexed(Multiplexed<'a>),
    /// The LSS master asks.
    LssRequest(lss::Request),
    /// An LSS slave answers.
    LssResponse(lss::Response),
    /// The identifier is of that service, and the frame is not as the standard has it.
    Malformed(&'static str),
    /// The identifier is of no service that is known.
    Unknown,
}

/// A frame of an SDO transfer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exchange<'a> {
    /// Whose server.
    pub node_id: NodeId,
    /// Which server, 0 for the first.
    pub server: u8,
    /// Whether the client speaks.
    pub is_request: bool,
    /// What it does.
    pub step: Step,
    /// The object of [`Step::address`].
    pub object: Option<&'a Described>,
    /// The bytes that have gone over so far.
    pub value: &'a [u8],
}

/// A PDO.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Received<'a> {
    /// Whose.
    pub node_id: NodeId,
    /// Seen from that node.
    pub direction: Direction,
    /// 1 to 512.
    pub number: u16,
    /// What is mapped.
    pub fields: &'a [Field<'a>],
    /// The data.
    pub word: u64,
    /// How many bytes of it.
    pub length: usize,
    /// A remote frame: somebody asks for the PDO.
    pub is_request: bool,
}

/// A PDO that says which object it carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Multiplexed<'a> {
    /// Whose.
    pub node_id: NodeId,
    /// Seen from that node.
    pub direction: Direction,
    /// 1 to 512.
    pub number: u16,
    /// Who is meant, 0 for all, when the object is the receiver's; `None` when it is the sender's.
    pub receiver: Option<u8>,
    /// The object.
    pub address: Address,
    /// What is known of it.
    pub object: Option<&'a Described>,
    /// Its value.
    pub value: [u8; 4],
}

impl Exchange<'_> {
    /// The value that this frame completes.
    #[must_use]
    pub fn transferred(&self) -> Option<Value> {
        let Ended {
            outcome: Outcome::Value { sized },
            ..
        } = self.step.ended?
        else {
            return None;
        };
        Some(self.value_as(sized))
    }

    /// The bytes of the value that this frame completes.
    pub(super) fn transferred_bytes(&self) -> &[u8] {
        match self.step.ended {
            Some(Ended {
                outcome: Outcome::Value { sized },
                ..
            }) => value::counting(self.value, sized, self.object.map(|object| object.data_type)),
            _ => &[],
        }
    }

    /// What has gone over so far.
    pub(super) fn value_as(&self, sized: bool) -> Value {
        value::of_bytes(self.value, sized, self.object.map(|object| object.data_type))
    }
}

impl<'a> Received<'a> {
    /// How many bytes the mapping has.
    #[must_use]
    pub fn mapped_length(&self) -> usize {
        let bits: usize = self.fields.iter().map(|field| usize::from(field.bits)).sum();
        bits.div_ceil(8)
    }

    /// The objects that are whole in the frame, with their values.
    pub fn values(&self) -> impl Iterator<Item = (&'a Field<'a>, Value)> {
        let (word, bits) = (self.word, u32::try_from(self.length * 8).unwrap_or(64));
        self.fields
            .iter()
            .scan(0, move |end, field| {
                let offset = *end;
                *end += u32::from(field.bits);
                Some((offset, *end, field))
            })
            .take_while(move |(_, end, _)| *end <= bits)
            .map(move |(offset, _, field)| (field, field.value(word, offset)))
    }
}

impl Multiplexed<'_> {
    /// The value by its data type.
    #[must_use]
    pub fn value(&self) -> Value {
        value::of_bytes(&self.value, false, self.object.map(|object| object.data_type))
    }
}
