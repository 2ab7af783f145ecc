//! Frames in the words of the dictionary: which service a frame is of, and what it says of which object.
//!
//! | module | does |
//! |---|---|
//! | `description` | the names, data types and communication parameters of an EDS |
//! | `conversation`, `block` | SDO transfers of all kinds, put together from what both sides say |
//! | `node`, `pdo` | what is known of one node: PDOs with the mapping in force |
//! | `route` | CAN-ID → service |
//! | `message`, `emergency` | what a frame says |
//! | `survey` | what is known of each node at the end |
//! | `text`, `lss`, `json` | the same as a line for people and for programs |
//!
//! The communication parameters begin with what the file says and follow what is written and read over SDO. A boot-up takes
//! them back to what the file says, or to what was in force when "save" was written to 1010h.

mod block;
mod conversation;
mod description;
mod emergency;
mod json;
mod lss;
mod message;
mod node;
mod pdo;
mod route;
mod survey;
mod text;
mod value;

use lexican_runtime::{
    Address, NodeId,
    od::TimeOfDay,
    wire::{Frame, emcy, lss as wire_lss, nmt, sync},
};

pub use conversation::{Access, Conversation, Ended, Outcome, Said, Step};
pub use description::{Described, Description};
pub use json::write_json;
pub use message::{Exchange, Message, Multiplexed, Received};
pub use pdo::{Direction, Field};
pub use survey::{Overheard, Survey, WrongPdo};
pub use text::write_text;

use node::Node;
use route::{Route, Routes};

/// One bus, overheard.
#[derive(Debug)]
pub struct Decoder<'d> {
    /// By node-ID.
    nodes: Vec<Option<Node<'d>>>,
    /// What describes the nodes that nothing else does.
    default: Option<&'d Description>,
    routes: Routes,
}

impl<'d> Decoder<'d> {
    /// A bus of which nothing is known. Nodes that are not described otherwise are as `default` says, if it is there.
    #[must_use]
    pub fn new(default: Option<&'d Description>) -> Self {
        Self {
            nodes: (0..=127).map(|_| None).collect(),
            default,
            routes: Routes::new(),
        }
    }

    /// `node_id` is a device of that description.
    pub fn describe(&mut self, node_id: NodeId, description: &'d Description) {
        self.add(Node::new(node_id, Some(description)));
    }

    /// What the next frame of the bus says.
    pub fn decode(&mut self, frame: &Frame) -> Message<'_> {
        let mut route = self.routes.find(frame.id());
        if let Some(node_id) = route.stranger(frame.id(), |node_id| self.node(node_id).is_some()) {
            self.add(Node::new(node_id, self.default));
            route = self.routes.find(frame.id());
        }
        match route {
            Route::Nmt => nmt::Request::parse(frame.data()).map_or(Message::Malformed("NMT"), Message::Nmt),
            Route::Sync => sync_message(frame),
            Route::Time => time_message(frame),
            Route::LssRequest => lss_message(frame, wire_lss::Request::parse, Message::LssRequest),
            Route::LssResponse => lss_message(frame, wire_lss::Response::parse, Message::LssResponse),
            Route::ErrorControl(node_id) => self.error_control(node_id, frame),
            Route::Emergency(node_id) => self.emergency(node_id, frame),
            Route::SdoRequest { node, server } => self.sdo(node, server, true, frame),
            Route::SdoResponse { node, server } => self.sdo(node, server, false, frame),
            Route::Pdo { node, at } => self.pdo(node, at, frame),
            Route::None => Message::Unknown,
        }
    }

    fn node(&self, node_id: NodeId) -> Option<&Node<'d>> {
        self.nodes.get(usize::from(node_id.get()))?.as_ref()
    }

    fn add(&mut self, node: Node<'d>) {
        self.routes.replace(&node);
        if let Some(place) = self.nodes.get_mut(usize::from(node.id.get())) {
            *place = Some(node);
        }
    }

    fn error_control(&mut self, node_id: NodeId, frame: &Frame) -> Message<'_> {
        if frame.is_remote() {
            return Message::Guarding(node_id);
        }
        let &[byte] = frame.data() else {
            return Message::Malformed("error control");
        };
        let Some(state) = nmt::NmtState::from_number(byte & 0x7F) else {
            return Message::Malformed("error control");
        };
        if byte != 0 {
            return Message::Heartbeat {
                node_id,
                state,
                toggle: byte & 0x80 != 0,
            };
        }
        if let Some(node) = self.nodes.get_mut(usize::from(node_id.get())).and_then(Option::as_mut) {
            node.boot_up();
            self.routes.replace(node);
        }
        Message::BootUp(node_id)
    }

    fn emergency(&self, node_id: NodeId, frame: &Frame) -> Message<'_> {
        let Some(data) = frame.full_data() else {
            return Message::Malformed("EMCY");
        };
        let description = self.node(node_id).and_then(|node| node.description);
        Message::Emergency {
            node_id,
            emergency: emcy::Emergency::parse(data),
            meaning: emergency::meaning(
                emcy::Emergency::parse(data).code,
                description.is_some_and(Description::is_encoder),
            ),
        }
    }

    fn sdo(&mut self, node_id: NodeId, server: u8, is_request: bool, frame: &Frame) -> Message<'_> {
        let Some(data) = frame.full_data() else {
            return Message::Malformed("SDO");
        };
        let Some(node) = self.nodes.get_mut(usize::from(node_id.get())).and_then(Option::as_mut) else {
            return Message::Unknown;
        };
        let conversation = node.conversation(server);
        let step = if is_request {
            conversation.request(data)
        } else {
            conversation.response(data)
        };
        if step.ended.is_some_and(|ended| node.overhear(ended, server)) {
            self.routes.replace(node);
        }
        Message::Sdo(Exchange {
            node_id,
            server,
            is_request,
            step,
            object: step.address.and_then(|address| node.described(address)),
            value: node.value(server),
        })
    }

    fn pdo(&self, node_id: NodeId, at: u16, frame: &Frame) -> Message<'_> {
        let pdo = self.node(node_id).and_then(|node| node.pdos.get(usize::from(at)));
        let Some(pdo) = pdo else { return Message::Unknown };
        if pdo.is_multiplexed {
            return self.multiplexed(node_id, pdo.number, pdo.direction, frame);
        }
        Message::Pdo(Received {
            node_id,
            direction: pdo.direction,
            number: pdo.number,
            fields: &pdo.fields,
            word: frame.word(),
            length: frame.data().len(),
            is_request: frame.is_remote(),
        })
    }

    fn multiplexed(&self, node_id: NodeId, number: u16, direction: Direction, frame: &Frame) -> Message<'_> {
        let Some([who, i0, i1, sub, v0, v1, v2, v3]) = frame.full_data() else {
            return Message::Malformed("MPDO");
        };
        let address = Address::new(u16::from_le_bytes([i0, i1]), sub);
        let receiver = (who & 0x80 != 0).then_some(who & 0x7F);
        // The object is of the sender, or of the receiver that the frame names.
        let owner = NodeId::new(who & 0x7F).unwrap_or(node_id);
        Message::Multiplexed(Multiplexed {
            node_id,
            direction,
            number,
            receiver,
            address,
            object: self.node(owner).and_then(|node| node.described(address)),
            value: [v0, v1, v2, v3],
        })
    }
}

fn sync_message(frame: &Frame) -> Message<'static> {
    match (sync::parse(frame, false), sync::parse(frame, true)) {
        (Some(_), _) => Message::Sync(None),
        (None, Some(counter)) => Message::Sync(Some(counter)),
        (None, None) => Message::Malformed("SYNC"),
    }
}

fn time_message(frame: &Frame) -> Message<'static> {
    let bytes = frame.data().try_into();
    bytes.map_or(Message::Malformed("TIME"), |bytes| {
        Message::Time(TimeOfDay::from_bytes(bytes))
    })
}

fn lss_message<T>(
    frame: &Frame,
    parse: impl Fn([u8; 8]) -> Option<T>,
    message: impl Fn(T) -> Message<'static>,
) -> Message<'static> {
    let said = frame.full_data().and_then(parse);
    said.map_or(Message::Malformed("LSS"), message)
}
