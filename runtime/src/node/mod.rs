//! The node: ties the services to one bus.

mod dispatch;
mod pending;

use dispatch::Service;
use pending::Pending;

use crate::{
    heartbeat::{self, PRODUCER_HEARTBEAT_TIME},
    nmt,
    od::{self, Device, Reset, Services, Value},
    sdo,
    wire::{
        self,
        nmt::{NmtCommand, NmtState},
        CanId, Frame,
    },
    AbortCode, Address, Instant, NodeId,
};

/// A CANopen slave.
///
/// It has neither clock nor bus: the main loop hands it each frame that arrives ([`Node::receive`]), sends what it has to
/// say ([`Node::poll`], until there is nothing more), and may sleep until [`Node::poll_at`].
///
#[derive(Clone, Debug)]
pub struct Node<D: Device> {
    device: D,
    id: NodeId,
    nmt: nmt::Slave,
    heartbeat: heartbeat::Producer,
    sdo: sdo::Server<D::Buffer>,
    /// The SDO server's response, while [`Pending::SDO`].
    response: [u8; 8],
    pending: Pending,
    /// When the first timer of any service runs out.
    due: Instant,
}

impl<D: Device> Node<D> {
    /// A node after power-on; its first [`Node::poll`] gives the boot-up message. The dictionary's formulas of `$NODEID`
    /// get their values now.
    #[must_use]
    pub fn new(mut device: D, node_id: NodeId) -> Self {
        od::resolve_node_id(&mut device, node_id);
        let buffer = device.buffer();
        Self {
            device,
            id: node_id,
            nmt: nmt::Slave::new(),
            heartbeat: heartbeat::Producer::new(),
            sdo: sdo::Server::new(buffer),
            response: [0; 8],
            pending: Pending::BOOT_UP,
            due: Instant::NEVER,
        }
    }

    /// Takes a frame from the bus. What is not for this node is ignored.
    #[inline]
    pub fn receive(&mut self, now: Instant, frame: &Frame) {
        match dispatch::service(frame, self.id) {
            Service::Sdo(request) => self.receive_sdo(now, request),
            Service::Nmt => self.receive_nmt(frame),
            Service::None => {}
        }
    }

    /// The next frame to send at `now`; `None` when there is nothing (more) to say.
    #[inline]
    pub fn poll(&mut self, now: Instant) -> Option<Frame> {
        if self.pending == Pending::NOTHING && now < self.due {
            return None;
        }
        self.work(now)
    }

    /// When [`Node::poll`] is to be called next, if no frame arrives before: an instant that has passed when there is
    /// something to send already, `None` when nothing will ever be due.
    #[must_use]
    pub fn poll_at(&self) -> Option<Instant> {
        if self.pending != Pending::NOTHING {
            return Some(Instant::default());
        }
        Some(self.due).filter(|due| *due != Instant::NEVER)
    }

    /// The NMT state.
    #[inline]
    #[must_use]
    pub fn state(&self) -> NmtState {
        self.nmt.state()
    }

    /// The node-ID.
    #[inline]
    #[must_use]
    pub fn node_id(&self) -> NodeId {
        self.id
    }

    /// Gives the node another node-ID: it resets its communication and boots up under the new one.
    pub fn set_node_id(&mut self, node_id: NodeId) {
        self.id = node_id;
        od::resolve_node_id(&mut self.device, node_id);
        self.obey(NmtCommand::ResetCommunication);
    }

    /// The device: its dictionary and its application.
    #[inline]
    #[must_use]
    pub fn device(&self) -> &D {
        &self.device
    }

    /// The device, to change. The producer heartbeat time takes effect at the next [`Node::poll`], however it was written.
    #[inline]
    pub fn device_mut(&mut self) -> &mut D {
        self.pending.add(Pending::CONFIGURATION);
        &mut self.device
    }

    /// Sets how long an SDO client may leave a transfer open, in ms; 1000 unless set.
    pub fn set_sdo_timeout(&mut self, timeout_ms: u32) {
        self.sdo.set_timeout(timeout_ms);
    }

    /// Reads the value at `address` as a client would, the application's handler included.
    ///
    /// # Errors
    /// As [`od::read`].
    pub fn read(&mut self, address: Address) -> Result<Value<'_>, AbortCode> {
        od::read(&mut self.device, address)
    }

    /// Writes `data`, little-endian as on the bus, to `address` as a client would: checked, and with its effects.
    ///
    /// # Errors
    /// As [`od::write()`].
    pub fn write(&mut self, address: Address, data: &[u8]) -> Result<(), AbortCode> {
        od::write(&mut self.device, &mut Effects(&mut self.pending), address, data)
    }

    /// Obeys an NMT command as if it came from the master.
    pub fn obey(&mut self, command: NmtCommand) {
        if let Some(reset) = self.nmt.obey(command) {
            self.reset(reset);
        } else if !self.nmt.serves_sdo() {
            self.end_transfer();
        }
    }

    #[inline]
    fn receive_sdo(&mut self, now: Instant, request: [u8; 8]) {
        if !self.nmt.serves_sdo() {
            return;
        }
        // A request makes the answer to the one before it stale.
        self.pending.remove(Pending::SDO);
        let mut effects = Effects(&mut self.pending);
        if let Some(response) = self.sdo.receive(now, &mut self.device, &mut effects, request) {
            self.response = response;
            self.pending.add(Pending::SDO);
        }
        self.due = self.sdo.due().min(self.heartbeat.due());
    }

    fn receive_nmt(&mut self, frame: &Frame) {
        if let Some(request) = wire::nmt::Request::parse(frame.data()) {
            if request.recipient.includes(self.id) {
                self.obey(request.command);
            }
        }
    }

    fn reset(&mut self, reset: Reset) {
        od::restore(&mut self.device, reset, self.id);
        self.device.after_reset(reset);
        self.end_transfer();
        self.heartbeat = heartbeat::Producer::new();
        self.due = Instant::NEVER;
        self.pending = Pending::BOOT_UP;
    }

    fn end_transfer(&mut self) {
        self.sdo.reset();
        self.pending.remove(Pending::SDO);
    }

    /// What [`Node::poll`] does when there is something to do. The frames come in the order of their CAN-IDs, as the bus
    /// would let them through.
    fn work(&mut self, now: Instant) -> Option<Frame> {
        if self.pending.take(Pending::BOOT_UP) {
            return Some(self.boot_up(now));
        }
        if self.pending.take(Pending::CONFIGURATION) {
            self.configure(now);
        }
        if now >= self.due {
            self.expire(now);
        }
        if self.pending.take(Pending::SDO) {
            return Some(Frame::full(CanId::sdo_response(self.id), self.response));
        }
        if self.pending.take(Pending::HEARTBEAT) {
            return Some(wire::heartbeat::emit(self.id, self.nmt.state()));
        }
        None
    }

    /// Leaves INITIALISING with the boot-up message.
    fn boot_up(&mut self, now: Instant) -> Frame {
        let frame = wire::heartbeat::emit(self.id, NmtState::Initialising);
        self.pending = Pending::NOTHING;
        self.nmt.booted();
        let period = self.heartbeat_time();
        self.heartbeat.start(now, period);
        self.due = self.heartbeat.due();
        frame
    }

    /// Looks at the objects of the services.
    fn configure(&mut self, now: Instant) {
        let period = self.heartbeat_time();
        self.heartbeat.configure(now, period);
        self.due = self.sdo.due().min(self.heartbeat.due());
    }

    /// 1017h in ms; 0, no heartbeat, for a device without it.
    #[inline]
    fn heartbeat_time(&self) -> u16 {
        let time = od::number(&self.device, PRODUCER_HEARTBEAT_TIME);
        time.and_then(|time| u16::try_from(time).ok()).unwrap_or(0)
    }

    /// Looks at the timers.
    fn expire(&mut self, now: Instant) {
        if let Some(abort) = self.sdo.expire(now) {
            self.response = abort;
            self.pending.add(Pending::SDO);
        }
        if now >= self.heartbeat.due() {
            self.heartbeat.sent(now);
            self.pending.add(Pending::HEARTBEAT);
        }
        self.due = self.sdo.due().min(self.heartbeat.due());
    }
}

/// What a write to an object of the services brings about.
struct Effects<'a>(&'a mut Pending);

impl Services for Effects<'_> {
    fn after_write(&mut self, _: Address) {
        self.0.add(Pending::CONFIGURATION);
    }
}
