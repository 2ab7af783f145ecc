//! What a log tells of each node: the values that it was asked for, its heartbeats and emergencies, its PDOs.

use std::collections::BTreeMap;

use lexican_eds::{
    dump::{AbortCode, Answer, Dump},
    ir,
};
use lexican_runtime::{
    Address, Instant, NodeId,
    wire::{emcy::Emergency, nmt::NmtState},
};

use super::{Access, Direction, Ended, Exchange, Message, Outcome, Received};

/// How many emergencies of a node are remembered one by one.
const REMEMBERED: usize = 20;

/// The nodes of a bus, as they were overheard.
#[derive(Clone, Debug, Default)]
pub struct Survey {
    nodes: BTreeMap<NodeId, Overheard>,
}

/// One node.
#[derive(Clone, Debug)]
pub struct Overheard {
    /// What it answered when it was read, the last answer of each object. A value is not replaced by silence.
    pub dump: Dump,
    /// How often it has started.
    pub boot_ups: u64,
    /// How many heartbeats and answers to node guarding it has sent.
    pub heartbeats: u64,
    /// What the last of them says.
    pub state: Option<NmtState>,
    /// How many emergencies it has sent.
    pub emergencies: u64,
    /// The first 20 of them, with the error code in words.
    pub first_emergencies: Vec<(Instant, Emergency, &'static str)>,
    /// PDOs that were shorter or longer than the mapping in force, how often, and their lengths in bytes: that of the last
    /// frame, that of the mapping.
    pub wrong_pdos: BTreeMap<(Direction, u16), WrongPdo>,
    /// How many transfers are not in the log as a whole.
    pub incomplete: u64,
}

/// A PDO that is not as long as its mapping.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WrongPdo {
    /// How many frames.
    pub frames: u64,
    /// Bytes in the last of them.
    pub length: usize,
    /// Bytes that are mapped.
    pub mapped: usize,
}

impl Survey {
    /// The nodes that were heard, by node-ID.
    pub fn nodes(&self) -> impl Iterator<Item = (NodeId, &Overheard)> {
        self.nodes.iter().map(|(node_id, overheard)| (*node_id, overheard))
    }

    /// What was heard of `node_id`; `None` when nothing was.
    #[must_use]
    pub fn node(&self, node_id: NodeId) -> Option<&Overheard> {
        self.nodes.get(&node_id)
    }

    /// Takes what the next frame, of `time`, says.
    pub fn hear(&mut self, time: Instant, message: &Message<'_>) {
        match message {
            Message::BootUp(node_id) => self.of(*node_id).boot_ups += 1,
            Message::Heartbeat { node_id, state, .. } => {
                let node = self.of(*node_id);
                node.heartbeats += 1;
                node.state = Some(*state);
            }
            Message::Emergency {
                node_id,
                emergency,
                meaning,
            } => self.of(*node_id).hear_emergency(time, *emergency, meaning),
            Message::Sdo(exchange) if exchange.server == 0 => self.of(exchange.node_id).hear_sdo(exchange),
            Message::Pdo(pdo) => self.of(pdo.node_id).hear_pdo(pdo),
            _ => {}
        }
    }

    fn of(&mut self, node_id: NodeId) -> &mut Overheard {
        self.nodes.entry(node_id).or_insert_with(|| Overheard::new(node_id))
    }
}

impl Overheard {
    fn new(node_id: NodeId) -> Self {
        // Both crates have node-IDs from 1 to 127.
        let node_id = ir::NodeId::new(node_id.get()).unwrap_or(FIRST);
        Self {
            dump: Dump::new(node_id),
            boot_ups: 0,
            heartbeats: 0,
            state: None,
            emergencies: 0,
            first_emergencies: Vec::new(),
            wrong_pdos: BTreeMap::new(),
            incomplete: 0,
        }
    }

    fn hear_emergency(&mut self, time: Instant, emergency: Emergency, meaning: &'static str) {
        self.emergencies += 1;
        if self.first_emergencies.len() < REMEMBERED {
            self.first_emergencies.push((time, emergency, meaning));
        }
    }

    fn hear_sdo(&mut self, exchange: &Exchange<'_>) {
        if let Some(left) = exchange.step.before {
            self.hear_end(left, &[]);
        }
        if let Some(ended) = exchange.step.ended {
            self.hear_end(ended, exchange.transferred_bytes());
        }
    }

    fn hear_end(&mut self, ended: Ended, value: &[u8]) {
        let answer = match ended.outcome {
            Outcome::Incomplete => {
                self.incomplete += 1;
                return;
            }
            Outcome::Value { .. } => Answer::Value(value.to_vec()),
            Outcome::Abort(code) => Answer::Abort(AbortCode(code.0)),
            Outcome::Unanswered => Answer::Timeout,
        };
        if ended.access == Access::Write {
            return;
        }
        let Address { index, sub } = ended.address;
        let address = ir::Address::new(index, sub);
        if answer != Answer::Timeout || self.dump.answer(address).is_none() {
            self.dump.objects.insert(address, answer);
        }
    }

    fn hear_pdo(&mut self, pdo: &Received<'_>) {
        let mapped = pdo.mapped_length();
        if pdo.is_request || pdo.length == mapped {
            return;
        }
        let wrong = self.wrong_pdos.entry((pdo.direction, pdo.number)).or_default();
        *wrong = WrongPdo {
            frames: wrong.frames + 1,
            length: pdo.length,
            mapped,
        };
    }
}

/// Node 1.
const FIRST: ir::NodeId = match ir::NodeId::new(1) {
    Some(node_id) => node_id,
    None => unreachable!(),
};
