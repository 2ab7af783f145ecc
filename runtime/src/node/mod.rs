//! The node: ties the services to one bus.

mod application;
mod dispatch;
mod effects;
mod error_control;
mod exchange;
mod lss;
mod pending;
mod servers;
mod storage;

use dispatch::Service;
use effects::Effects;
use pending::Pending;

use crate::{
    emcy, guarding,
    heartbeat::{self, PRODUCER_HEARTBEAT_TIME},
    lss::Slave,
    nmt,
    od::{self, Device, Reset, ServiceSet},
    pdo, sdo, sync,
    wire::{
        self,
        nmt::{NmtCommand, NmtState},
        CanId, Frame,
    },
    BusState, Event, Instant, NodeId,
};

/// A CANopen slave.
///
/// It has neither clock nor bus: the main loop hands it each frame that arrives ([`Node::receive`]), sends what it has to
/// say ([`Node::poll`], until there is nothing more), and may sleep until [`Node::poll_at`].
///
#[derive(Clone, Debug)]
#[repr(C)] // What is looked at most stands first: near fields take shorter instructions.
pub struct Node<D: Device> {
    /// When the first timer of any service runs out.
    due: Instant,
    /// The same but for the SDO server.
    timers: Instant,
    pending: Pending,
    id: NodeId,
    nmt: nmt::Slave,
    bus_state: BusState,
    /// Whether the last SYNC had the wrong length.
    is_sync_wrong: bool,
    /// The SDO server's response, while [`Pending::SDO`].
    response: [u8; 8],
    /// The LSS slave's response, while [`Pending::LSS`].
    lss_response: [u8; 8],
    heartbeat: heartbeat::Producer,
    sync_consumer: sync::Consumer,
    sync: sync::Producer,
    lss: Slave,
    guarding: guarding::Slave,
    /// What was last reported of RPDOs.
    faults: pdo::Faults,
    consumers: heartbeat::Consumers<D::Watches>,
    sdo: sdo::Server<D::Buffer>,
    /// The SDO servers beyond the first.
    channels: D::Servers,
    emcy: emcy::Producer,
    pdos: pdo::Set<D::Pdos>,
    device: D,
}

impl<D: Device> Node<D> {
    /// A node after power-on; its first [`Node::poll`] gives the boot-up message. The dictionary's formulas of `$NODEID`
    /// get their values now, then what is stored ([`crate::storage`]); a node-ID that LSS has stored takes the place of `node_id`.
    #[must_use]
    pub fn new(device: D, node_id: NodeId) -> Self {
        Self::start(device, node_id)
    }

    fn start(mut device: D, node_id: NodeId) -> Self {
        let (node_id, bit_rate) = Self::power_on(&mut device, node_id);
        let buffer = device.buffer();
        let mut pdos = pdo::Set::new(&device, device.pdos());
        pdos.reset();
        let consumers = heartbeat::Consumers::new(device.watches());
        let mut channels = device.servers();
        sdo::Channel::assign(&device, channels.as_mut());
        Self {
            device,
            id: node_id,
            nmt: nmt::Slave::new(),
            lss: Slave::new(node_id, bit_rate),
            emcy: emcy::Producer::new(),
            heartbeat: heartbeat::Producer::new(),
            consumers,
            guarding: guarding::Slave::new(),
            bus_state: BusState::Active,
            sync: sync::Producer::new(),
            sync_consumer: sync::Consumer::default(),
            pdos,
            faults: pdo::Faults::default(),
            is_sync_wrong: false,
            sdo: sdo::Server::new(buffer),
            response: [0; 8],
            lss_response: [0; 8],
            channels,
            pending: Pending::of_start(node_id),
            due: Instant::NEVER,
            timers: Instant::NEVER,
        }
    }

    /// Takes a frame from the bus. What is not for this node is ignored.
    #[inline]
    pub fn receive(&mut self, now: Instant, frame: &Frame) {
        match dispatch::service::<D>(frame, self.id) {
            Service::Sdo(request) => self.receive_sdo(now, request),
            Service::Nmt => self.receive_nmt(frame),
            Service::Lss(request) => self.receive_lss(now, request),
            Service::Other => self.receive_other(now, frame),
        }
    }

    /// The next frame to send at `now`; `None` when there is nothing (more) to say.
    #[inline]
    pub fn poll(&mut self, now: Instant) -> Option<Frame> {
        if now < self.due {
            match self.pending {
                Pending::NOTHING => return None,
                Pending::SDO => return Some(self.send_response()),
                Pending::PDO => return self.send_pdo(now),
                Pending::BLOCK => return self.send_segment(now),
                _ => {}
            }
        }
        self.work(now)
    }

    /// When [`Node::poll`] is to be called next, if no frame arrives before: an instant that has passed when there is
    /// something to send already, `None` when nothing will ever be due.
    #[must_use]
    pub fn poll_at(&self) -> Option<Instant> {
        if self.is_silent() {
            return self.poll_silent_at();
        }
        if self.pending != Pending::NOTHING {
            return Some(Instant::default());
        }
        Some(self.due).filter(|due| *due != Instant::NEVER)
    }

    /// Obeys an NMT command as if it came from the master.
    pub fn obey(&mut self, command: NmtCommand) {
        let before = self.nmt.state();
        if let Some(reset) = self.nmt.obey(command) {
            self.reset(reset);
            return;
        }
        if self.nmt.state() != before {
            self.device.event(Event::State(self.nmt.state()));
        }
        if !self.nmt.serves_sdo() {
            self.end_transfers();
        }
        if !self.nmt.exchanges_pdos() {
            self.end_exchange();
        }
        self.tell_emergencies();
        self.pending.add(Pending::CONFIGURATION);
    }

    #[inline]
    fn receive_sdo(&mut self, now: Instant, request: [u8; 8]) {
        if !self.nmt.serves_sdo() {
            return;
        }
        // A request makes the answer to the one before it stale.
        self.pending.remove(Pending::SDO_ALL);
        let mut effects = Effects {
            pending: &mut self.pending,
            pdos: &mut self.pdos,
        };
        match self.sdo.receive(now, &mut self.device, &mut effects, request) {
            sdo::Answer::Response(response) => {
                self.response = response;
                self.pending.add(Pending::SDO);
            }
            sdo::Answer::Block => self.pending.add(Pending::BLOCK),
            sdo::Answer::Nothing => {}
        }
        self.due = self.sdo.due().min(self.timers);
    }

    fn receive_nmt(&mut self, frame: &Frame) {
        if let Some(request) = wire::nmt::Request::parse(frame.data()) {
            if request.recipient.includes(self.id) {
                self.obey(request.command);
            }
        }
    }

    fn reset(&mut self, reset: Reset) {
        if D::SERVICES.has(ServiceSet::LSS) {
            self.reset_lss(reset);
        }
        od::restore(&mut self.device, reset, self.id);
        self.load(reset);
        self.device.event(Event::Reset(reset));
        self.end_transfers();
        self.emcy.reset(&mut self.device);
        self.heartbeat = heartbeat::Producer::new();
        self.consumers.reset();
        self.guarding = guarding::Slave::new();
        self.sync = sync::Producer::new();
        self.pdos.reset();
        self.faults = pdo::Faults::default();
        self.is_sync_wrong = false;
        self.due = Instant::NEVER;
        self.pending = self.pending_after_reset();
    }

    fn end_transfers(&mut self) {
        self.sdo.reset();
        self.pending.remove(Pending::SDO_ALL);
        if D::SERVICES.has(ServiceSet::SDO_SERVERS) {
            self.end_servers();
        }
    }

    /// Lets the emergency messages out when the NMT state allows them (CiA 301, 7.3.2.2), else keeps them.
    #[inline(never)]
    fn tell_emergencies(&mut self) {
        if self.emcy.has_message() && self.nmt.sends_emcy() {
            self.pending.add(Pending::EMCY);
        } else {
            self.pending.remove(Pending::EMCY);
        }
    }

    /// What [`Node::poll`] does when there is something to do. The frames come in the order of their CAN-IDs, as the bus
    /// would let them through.
    #[inline(never)]
    fn work(&mut self, now: Instant) -> Option<Frame> {
        if self.is_silent() && self.keeps_silence(now) {
            return self.send_lss_response();
        }
        if self.pending.take(Pending::BOOT_UP) {
            return Some(self.boot_up(now));
        }
        if D::SERVICES.has(ServiceSet::START_UP) && self.pending.take(Pending::START_ALL) {
            return wire::nmt::Request::START_ALL.emit();
        }
        // What runs out may be told to the application, which may then write what configures a service.
        for _ in 0..2 {
            if self.pending.take(Pending::CONFIGURATION) {
                self.configure(now);
            }
            if now >= self.due {
                self.expire(now);
            }
        }
        if D::SERVICES.has(ServiceSet::SYNC_PRODUCER) && self.pending.take(Pending::SYNC) {
            if let Some(frame) = self.send_sync(now) {
                return Some(frame);
            }
        }
        if self.pending.take(Pending::EMCY) {
            if let Some(frame) = self.send_emergency(now) {
                return Some(frame);
            }
        }
        if self.pending.has(Pending::PDO) {
            if let Some(frame) = self.send_pdo(now) {
                return Some(frame);
            }
        }
        if self.pending.has(Pending::SDO) {
            return Some(self.send_response());
        }
        if D::SERVICES.has(ServiceSet::SDO_SERVERS) && self.pending.has(Pending::SERVERS) {
            return self.send_servers(now);
        }
        if self.pending.has(Pending::BLOCK) {
            return self.send_segment(now);
        }
        if D::SERVICES.has(ServiceSet::NODE_GUARDING) && self.pending.take(Pending::GUARDING) {
            return Some(self.send_guarding(now));
        }
        if self.pending.take(Pending::HEARTBEAT) {
            return Some(wire::heartbeat::emit(self.id, self.nmt.state()));
        }
        self.send_lss_response()
    }

    /// Leaves INITIALISING with the boot-up message.
    fn boot_up(&mut self, now: Instant) -> Frame {
        let frame = wire::heartbeat::emit(self.id, NmtState::Initialising);
        self.pending = Pending::NOTHING;
        self.nmt.booted();
        self.device.event(Event::State(self.nmt.state()));
        let period = self.heartbeat_time();
        self.heartbeat.start(now, period);
        self.configure_services(now);
        self.start_up();
        self.tell_emergencies();
        self.schedule();
        frame
    }

    /// The SDO server's response.
    #[inline]
    fn send_response(&mut self) -> Frame {
        self.pending.remove(Pending::SDO);
        Frame::full(CanId::sdo_response(self.id), self.response)
    }

    /// The next segment of the SDO server's block.
    #[inline(never)]
    fn send_segment(&mut self, now: Instant) -> Option<Frame> {
        let next = self.sdo.next_segment(now, &mut self.device);
        if !next.is_some_and(|next| next.has_more) {
            self.pending.remove(Pending::BLOCK);
            self.due = self.sdo.due().min(self.timers);
        }
        next.map(|next| Frame::full(CanId::sdo_response(self.id), next.message))
    }

    /// The next emergency message, unless the inhibit time holds it back.
    fn send_emergency(&mut self, now: Instant) -> Option<Frame> {
        let frame = self.emcy.send(now, &self.device);
        if frame.is_some() {
            self.tell_emergencies();
        }
        self.schedule();
        frame
    }

    /// Looks at the objects of the services.
    fn configure(&mut self, now: Instant) {
        let period = self.heartbeat_time();
        self.heartbeat.configure(now, period);
        self.configure_services(now);
        self.schedule();
    }

    fn configure_services(&mut self, now: Instant) {
        self.configure_exchange(now);
        self.configure_error_control();
        if D::SERVICES.has(ServiceSet::SDO_SERVERS) {
            self.configure_servers();
        }
    }

    /// 1017h in ms; 0, no heartbeat, for a device without it.
    #[inline]
    fn heartbeat_time(&self) -> u16 {
        u16::try_from(od::parameter(&self.device, PRODUCER_HEARTBEAT_TIME)).unwrap_or(0)
    }

    /// Looks at the timers.
    fn expire(&mut self, now: Instant) {
        if let Some(abort) = self.sdo.expire(now) {
            self.response = abort;
            self.pending.add(Pending::SDO);
        }
        if D::SERVICES.has(ServiceSet::SDO_SERVERS) {
            self.expire_servers(now);
        }
        if now >= self.heartbeat.due() {
            self.heartbeat.sent(now);
            self.pending.add(Pending::HEARTBEAT);
        }
        if now >= self.emcy.due() {
            self.emcy.wake();
            self.tell_emergencies();
        }
        self.expire_exchange(now);
        self.expire_error_control(now);
        self.schedule();
    }

    /// Finds the first timer to run out.
    #[inline(never)]
    fn schedule(&mut self) {
        let mut due = self.heartbeat.due().min(self.emcy.due()).min(self.pdos.due());
        if D::SERVICES.has(ServiceSet::SYNC_PRODUCER) {
            due = due.min(self.sync.due());
        }
        if D::SERVICES.has(ServiceSet::HEARTBEAT_CONSUMER) {
            due = due.min(self.consumers.due());
        }
        if D::SERVICES.has(ServiceSet::NODE_GUARDING) {
            due = due.min(self.guarding.due());
        }
        if D::SERVICES.has(ServiceSet::SDO_SERVERS) {
            due = due.min(self.servers_due());
        }
        self.timers = due;
        self.due = self.sdo.due().min(due);
    }
}
