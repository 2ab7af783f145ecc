//! SYNC and PDOs: what comes and goes without being asked for.

use super::{Node, Pending};
use crate::{
    od::{Device, ServiceSet},
    sync, time,
    wire::{emcy::Emergency, nmt::NmtState, Frame},
    Address, Event, Instant, NodeId,
};

impl<D: Device> Node<D> {
    /// Sends TPDO `number`, 1 to 512, after an event in the application: at once, or as its transmission type, inhibit time
    /// and NMT state allow. The values are those of the moment of sending.
    ///
    /// `false`, and nothing is sent, when the node is not OPERATIONAL, the TPDO does not exist or is not valid, or its
    /// transmission type is none of 0, 254 and 255.
    pub fn trigger_tpdo(&mut self, number: u16) -> bool {
        let is_triggered = self.nmt.exchanges_pdos() && self.pdos.trigger(number);
        self.tell_pdos(is_triggered);
        is_triggered
    }

    /// As [`Node::trigger_tpdo`], of all TPDOs that carry the object at `address`, and of the multiplexed one if a scanner list
    /// (1FA0h to 1FCFh) has it; `false` when none is sent.
    pub fn object_changed(&mut self, address: Address) -> bool {
        if !self.nmt.exchanges_pdos() {
            return false;
        }
        let mut is_triggered = self.pdos.object_changed(&self.device, address);
        if D::SERVICES.has(ServiceSet::MPDO) {
            is_triggered |= self.pdos.scan(&mut self.device, self.id, address);
        }
        self.tell_pdos(is_triggered);
        is_triggered
    }

    /// Sends `value` to the object at `address` of `receiver`, or of all nodes, in the multiplexed TPDO with destination
    /// addressing: the first one whose mapping has FFh in sub-index 0 (CiA 301, 7.2.2.4). A value of fewer than four bytes
    /// stands in the low ones.
    ///
    /// `false`, and nothing is sent, when the node is not OPERATIONAL, there is no such TPDO or it is not valid, or the value
    /// before this one still waits.
    pub fn send_multiplexed(&mut self, receiver: Option<NodeId>, address: Address, value: u32) -> bool {
        let is_sent = D::SERVICES.has(ServiceSet::MPDO)
            && self.nmt.exchanges_pdos()
            && self.pdos.send_to(&self.device, receiver, address, value);
        self.tell_pdos(is_sent);
        is_sent
    }

    /// Takes a frame whose identifier is configured, or nobody's here: SYNC, RPDOs and requests for TPDOs in OPERATIONAL only.
    #[inline(never)]
    pub(super) fn receive_other(&mut self, now: Instant, frame: &Frame) {
        if self.nmt.state() == NmtState::Initialising
            || self.receive_servers(now, frame)
            || self.receive_error_control(now, frame)
            || self.receive_time(frame)
        {
            return;
        }
        if !self.nmt.exchanges_pdos() {
            return;
        }
        // What was written before the frame came is to be heeded.
        if self.pending.has(Pending::CONFIGURATION) {
            self.pending.remove(Pending::CONFIGURATION);
            self.configure(now);
        }
        match frame.data_id() {
            Some(id) if Some(id) == self.sync_consumer.id() => self.receive_sync(now, frame),
            Some(id) => {
                if self.pdos.receive(now, &mut self.device, self.id, id, frame) {
                    self.report_faults();
                    self.schedule();
                }
            }
            None => {
                let is_requested = self.pdos.ask(frame.id());
                self.tell_pdos(is_requested);
            }
        }
    }

    /// Takes a frame that may be TIME, in PRE-OPERATIONAL and OPERATIONAL; says whether it was.
    fn receive_time(&mut self, frame: &Frame) -> bool {
        if !D::SERVICES.has(ServiceSet::TIME) || !self.nmt.consumes_time() {
            return false;
        }
        let time = frame.data_id().and_then(|id| time::receive(&self.device, id, frame));
        if let Some(time) = time {
            self.device.event(Event::Time(time));
            self.pending.add(Pending::CONFIGURATION);
        }
        time.is_some()
    }

    /// A SYNC of the wrong length is reported and not taken (CiA 301, 7.5.2.19).
    fn receive_sync(&mut self, now: Instant, frame: &Frame) {
        let counter = self.sync_consumer.counter(frame);
        if counter.is_none() != self.is_sync_wrong {
            self.is_sync_wrong = counter.is_none();
            let emergency = Emergency::new(Emergency::UNEXPECTED_SYNC_LENGTH, Emergency::COMMUNICATION);
            self.report(emergency, self.is_sync_wrong);
        }
        if let Some(counter) = counter {
            self.synchronise(now, counter);
        }
    }

    /// A SYNC came from the bus, or went out.
    fn synchronise(&mut self, now: Instant, counter: u8) {
        let window = self.sync_consumer.window(now);
        let is_requested = self.pdos.sync(&mut self.device, counter, window);
        self.tell_pdos(is_requested);
    }

    /// The SYNC that is due. It is one for this node's own PDOs too.
    pub(super) fn send_sync(&mut self, now: Instant) -> Option<Frame> {
        let sent = self.sync.send(now, &self.device);
        self.schedule();
        let (frame, counter) = sent?;
        if self.nmt.exchanges_pdos() {
            self.synchronise(now, counter);
        }
        Some(frame)
    }

    /// The next TPDO, unless its inhibit time holds it back.
    #[inline(never)]
    pub(super) fn send_pdo(&mut self, now: Instant) -> Option<Frame> {
        let (frame, has_more) = self.pdos.send(now, &mut self.device);
        if !has_more {
            self.pending.remove(Pending::PDO);
        }
        // A timer may run now; none is earlier for one that does not any more.
        if self.pdos.due() < self.timers {
            self.schedule();
        }
        frame
    }

    /// Looks at the objects of SYNC and PDOs, and at the NMT state.
    pub(super) fn configure_exchange(&mut self, now: Instant) {
        self.sync_consumer = sync::Consumer::new(&self.device);
        if D::SERVICES.has(ServiceSet::SYNC_PRODUCER) {
            self.sync.configure(now, &self.device, self.nmt.produces_sync());
        }
        self.pdos.configure(now, &mut self.device, self.nmt.exchanges_pdos());
        self.report_faults();
    }

    /// Ends what belongs to OPERATIONAL.
    pub(super) fn end_exchange(&mut self) {
        self.pending.remove(Pending::PDO);
        self.pdos.stop();
        self.report_faults();
    }

    /// Looks at the timers.
    pub(super) fn expire_exchange(&mut self, now: Instant) {
        if D::SERVICES.has(ServiceSet::SYNC_PRODUCER) && now >= self.sync.due() {
            self.pending.add(Pending::SYNC);
        }
        let is_requested = self.pdos.expire(now);
        self.tell_pdos(is_requested);
        self.report_faults();
    }

    fn tell_pdos(&mut self, is_requested: bool) {
        if is_requested {
            self.pending.add(Pending::PDO);
        }
    }

    /// Raises and clears the emergencies of RPDOs.
    fn report_faults(&mut self) {
        if !D::SERVICES.has(ServiceSet::RPDO) {
            return;
        }
        let faults = self.pdos.faults();
        if faults == self.faults {
            return;
        }
        self.faults = faults;
        for (code, number) in [
            (Emergency::PDO_LENGTH_ERROR, faults.short),
            (Emergency::RPDO_TIMEOUT, faults.late),
        ] {
            let [low, high] = number.unwrap_or(0).to_le_bytes();
            let emergency = Emergency::new(code, Emergency::COMMUNICATION).with([low, high, 0, 0, 0]);
            self.report(emergency, number.is_some());
        }
    }

    /// Raises or clears an emergency.
    #[cold]
    pub(super) fn report(&mut self, emergency: Emergency, stands: bool) {
        if stands {
            self.raise_emergency(emergency);
        } else {
            self.clear_emergency(emergency.code);
        }
    }
}
