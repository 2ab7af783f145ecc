//! What is known of one node.

use std::collections::BTreeMap;

use lexican_runtime::{
    Address, NodeId,
    wire::{CanId, CobId},
};

use super::{
    Access, Conversation, Described, Description, Direction, Ended, Outcome, description::is_parameter, pdo::Pdo,
};

/// "save" (CiA 301, object 1010h).
const SAVE: &[u8] = b"save";
/// "load" (CiA 301, object 1011h).
const LOAD: &[u8] = b"load";

/// One node of a bus.
#[derive(Debug)]
pub(super) struct Node<'d> {
    pub(super) id: NodeId,
    pub(super) description: Option<&'d Description>,
    /// The communication parameters that are in force.
    values: BTreeMap<Address, u64>,
    /// Those that will be after the next boot-up.
    stored: BTreeMap<Address, u64>,
    pub(super) pdos: Vec<Pdo<'d>>,
    /// By the number of the server.
    conversations: Vec<Conversation>,
}

impl<'d> Node<'d> {
    pub(super) fn new(id: NodeId, description: Option<&'d Description>) -> Self {
        let values = description.map_or_else(BTreeMap::new, |description| description.parameters(id));
        let mut node = Self {
            id,
            description,
            stored: values.clone(),
            values,
            pdos: Vec::new(),
            conversations: Vec::new(),
        };
        node.read_pdos();
        node
    }

    /// What the file says of the object at `address`.
    pub(super) fn described(&self, address: Address) -> Option<&'d Described> {
        self.description?.object(address)
    }

    /// What is said to the server `number`, from 0.
    pub(super) fn conversation(&mut self, number: u8) -> &mut Conversation {
        let number = usize::from(number);
        if self.conversations.len() <= number {
            self.conversations.resize_with(number + 1, Conversation::default);
        }
        &mut self.conversations[number]
    }

    /// The value that went over last.
    pub(super) fn value(&self, server: u8) -> &[u8] {
        self.conversations
            .get(usize::from(server))
            .map_or(&[], |conversation| conversation.value())
    }

    /// The node has started: what was not saved is gone.
    pub(super) fn boot_up(&mut self) {
        self.values.clone_from(&self.stored);
        self.conversations.clear();
        self.read_pdos();
    }

    /// Learns from a transfer; tells whether other frames may be of other services now.
    pub(super) fn overhear(&mut self, ended: Ended, server: u8) -> bool {
        let (Outcome::Value { .. }, address) = (ended.outcome, ended.address) else {
            return false;
        };
        match (address.index, ended.access) {
            (0x1010, Access::Write) if self.value(server) == SAVE => self.stored.clone_from(&self.values),
            (0x1011, Access::Write) if self.value(server) == LOAD => {
                self.stored = self.description.map_or_else(BTreeMap::new, |it| it.parameters(self.id));
            }
            _ if is_parameter(address) => return self.learn(address, server),
            _ => {}
        }
        false
    }

    fn learn(&mut self, address: Address, server: u8) -> bool {
        let bytes = self.value(server).iter().rev();
        let value = bytes.fold(0, |value, byte| value << 8 | u64::from(*byte));
        if self.values.insert(address, value) == Some(value) {
            return false;
        }
        match Direction::of(address.index) {
            Some((direction, number)) => self.read_pdo(direction, number),
            None => true,
        }
    }

    fn read_pdos(&mut self) {
        self.pdos.clear();
        let indices: Vec<u16> = self
            .values
            .keys()
            .filter(|address| address.sub == 1)
            .map(|it| it.index)
            .collect();
        for (direction, number) in indices.into_iter().filter_map(Direction::of) {
            self.read_pdo(direction, number);
        }
    }

    /// Tells whether its identifier is another.
    fn read_pdo(&mut self, direction: Direction, number: u16) -> bool {
        let Some(pdo) = Pdo::new(direction, number, &self.values, self.description) else {
            return false;
        };
        let known = self
            .pdos
            .iter_mut()
            .find(|it| it.direction == direction && it.number == number);
        let Some(known) = known else {
            self.pdos.push(pdo);
            return true;
        };
        let has_moved = known.can_id != pdo.can_id;
        *known = pdo;
        has_moved
    }

    /// The identifier that the object at `address` configures; `None` when it is not there or switched off.
    pub(super) fn can_id(&self, address: Address) -> Option<CanId> {
        let cob_id = u32::try_from(*self.values.get(&address)?).ok().map(CobId)?;
        cob_id.can_id().filter(|_| cob_id.is_valid())
    }

    /// The same of an object in which bit 31 means something else: SYNC and TIME.
    pub(super) fn any_can_id(&self, address: Address) -> Option<CanId> {
        CobId(u32::try_from(*self.values.get(&address)?).ok()?).can_id()
    }

    /// Whether the file or the traffic says anything at `address`.
    pub(super) fn configures(&self, address: Address) -> bool {
        self.values.contains_key(&address)
    }
}
