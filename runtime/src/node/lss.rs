//! LSS: what the slave's reactions mean for the node.

use super::{
    storage::{DONE, NOT_SUPPORTED},
    Node, Pending,
};
use crate::{
    lss::{BitRate, Reaction, State},
    od::{self, Device, Reset, ServiceSet},
    wire::{
        lss::{Request, Response},
        nmt::NmtCommand,
        CanId, Frame,
    },
    AbortCode, Event, Instant, NodeId,
};

impl<D: Device> Node<D> {
    /// A node without a node-ID: it takes LSS messages only, and sends no other, until an LSS master has given it one.
    ///
    /// # Panics
    /// At compile time only, for a device without LSS ([`ServiceSet::LSS`]).
    #[must_use]
    pub fn unconfigured(device: D) -> Self {
        let () = Self::HAS_LSS;
        Self::start(device, NodeId::NONE)
    }

    const HAS_LSS: () = assert!(
        D::SERVICES.has(ServiceSet::LSS),
        "a device without LSS cannot be given a node-ID"
    );

    /// The state of the LSS slave, for the LEDs of CiA 303-3: both flicker in [`State::Configuration`].
    #[must_use]
    pub fn lss_state(&self) -> State {
        self.lss.state()
    }

    /// The bit rate that the CAN controller is to have; `None` while it is the application's choice, because neither LSS
    /// nor what is stored says one. [`Event::BitRate`] tells of a change.
    #[must_use]
    pub fn bit_rate(&self) -> Option<BitRate> {
        self.lss.bit_rate()
    }

    /// The node-ID and bit rate that were configured last, by an LSS master or [`Node::configure_lss`]: those that the next reset
    /// of the node finds, once they are stored. `None` for a node-ID that is yet to be given, and for a bit rate that is the
    /// application's choice.
    #[must_use]
    pub fn configured_lss(&self) -> (Option<NodeId>, Option<BitRate>) {
        (self.lss.pending_node_id(), self.lss.pending_bit_rate())
    }

    /// Configures node-ID and bit rate as an LSS master does, and stores them: for a device that has objects for them. They
    /// count from the next reset of the node on.
    ///
    /// # Errors
    /// As [`Node::save`]; they are configured all the same, and lost with the next reset.
    pub fn configure_lss(&mut self, node_id: NodeId, bit_rate: Option<BitRate>) -> Result<(), AbortCode> {
        self.prepare_lss(node_id, bit_rate);
        self.store_lss()
    }

    /// As [`Node::configure_lss`], but stores nothing: that is [`Node::store_lss`], for a device that does so when a client
    /// saves its parameters. Until then a node-ID counts from the next reset of communication on, and a reset of the node
    /// forgets it.
    pub fn prepare_lss(&mut self, node_id: NodeId, bit_rate: Option<BitRate>) {
        self.lss.configure_both(node_id, bit_rate);
    }

    /// Stores what was configured last, as an LSS master does by "store configuration".
    ///
    /// # Errors
    /// As [`Node::save`].
    pub fn store_lss(&mut self) -> Result<(), AbortCode> {
        match self.store_settings() {
            DONE => Ok(()),
            NOT_SUPPORTED => Err(AbortCode::NOT_STORED),
            _ => Err(AbortCode::HARDWARE_ERROR),
        }
    }

    /// Gives the CAN controller the bit rate that was configured last, without switch delays: for a device whose bit rate
    /// changes with a reset. [`Event::BitRate`] tells it, if it is another one.
    pub fn adopt_bit_rate(&mut self) {
        if let Some(bit_rate) = self.lss.adopt_bit_rate() {
            self.device.event(Event::BitRate(bit_rate));
        }
    }

    #[inline(never)]
    pub(super) fn receive_lss(&mut self, now: Instant, data: [u8; 8]) {
        let Some(request) = Request::parse(data) else { return };
        match self.lss.receive(now, &self.device, self.id, request) {
            Reaction::Nothing => {}
            Reaction::Answer(response) => self.answer(response),
            Reaction::Store => {
                let code = self.store_settings();
                self.answer(Response::Stored(code));
            }
            Reaction::Silence => self.pending.add(Pending::SILENCE),
            Reaction::BootUp => self.obey(NmtCommand::ResetCommunication),
        }
    }

    fn answer(&mut self, response: Response) {
        self.lss_response = response.emit();
        self.pending.add(Pending::LSS);
    }

    /// The LSS slave's response, if there is one.
    #[inline(never)]
    pub(super) fn send_lss_response(&mut self) -> Option<Frame> {
        let may_send = D::SERVICES.has(ServiceSet::LSS) && !self.lss.is_switching();
        let has_response = may_send && self.pending.take(Pending::LSS);
        has_response.then_some(Frame::full(CanId::LSS_RESPONSE, self.lss_response))
    }

    /// Makes the pending node-ID the active one, before anything else is reset.
    pub(super) fn reset_lss(&mut self, reset: Reset) {
        let node_id = self.lss.reset(reset);
        if node_id != self.id {
            self.id = node_id;
            od::resolve_node_id(&mut self.device, node_id);
        }
    }

    /// What there is to send when a reset is over.
    pub(super) fn pending_after_reset(&self) -> Pending {
        let pending = Pending::of_start(self.id);
        if self.lss.is_switching() {
            return pending.with(Pending::SILENCE);
        }
        pending
    }

    /// Whether nothing but the answers of LSS may be sent.
    #[inline]
    pub(super) fn is_silent(&self) -> bool {
        D::SERVICES.has(ServiceSet::LSS) && self.pending.has(Pending::SILENCE)
    }

    /// When [`Node::poll`] is to be called while the node is silent.
    pub(super) fn poll_silent_at(&self) -> Option<Instant> {
        if self.lss.is_switching() {
            return Some(self.lss.due());
        }
        self.pending.has(Pending::LSS).then_some(Instant::default())
    }

    /// Looks at the switch delays; `false` when silence is over.
    pub(super) fn keeps_silence(&mut self, now: Instant) -> bool {
        // Both delays are over at once when they are 0.
        while now >= self.lss.due() {
            self.lss.expire(now);
            let bit_rate = self.lss.bit_rate().filter(|_| self.lss.is_switching());
            if let Some(bit_rate) = bit_rate {
                self.device.event(Event::BitRate(bit_rate));
            }
        }
        if !self.lss.is_switching() && self.id != NodeId::NONE {
            self.pending.remove(Pending::SILENCE);
            return false;
        }
        true
    }
}
