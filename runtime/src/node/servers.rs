//! The SDO servers beyond the first (CiA 301, 7.5.2.33): 1201h to 127Fh.

use super::{effects::Effects, Node, Pending};
use crate::{
    od::{Device, ServiceSet},
    sdo::Channel,
    wire::Frame,
    Instant,
};

impl<D: Device> Node<D> {
    /// Takes a frame that may be a request to one of them; says whether it was.
    pub(super) fn receive_servers(&mut self, now: Instant, frame: &Frame) -> bool {
        if !D::SERVICES.has(ServiceSet::SDO_SERVERS) || !self.nmt.serves_sdo() {
            return false;
        }
        let Some(id) = frame.data_id() else { return false };
        let mut channels = self.channels.as_mut().iter_mut();
        let Some(channel) = channels.find(|channel| channel.is_asked(id)) else {
            return false;
        };
        // A shorter one is ignored, as by the first server.
        if let Some(request) = frame.full_data() {
            let mut effects = Effects {
                pending: &mut self.pending,
                pdos: &mut self.pdos,
            };
            channel.receive(now, &mut self.device, &mut effects, request);
            self.tell_servers();
            self.schedule();
        }
        true
    }

    /// The next frame of theirs: responses first, so that none waits for another server's block.
    pub(super) fn send_servers(&mut self, now: Instant) -> Option<Frame> {
        let channels = self.channels.as_mut();
        let response = channels.iter_mut().find_map(Channel::send_response);
        let frame = response.or_else(|| {
            let mut channels = channels.iter_mut();
            channels.find_map(|channel| channel.send_segment(now, &mut self.device))
        });
        self.tell_servers();
        self.schedule();
        frame
    }

    /// Looks at their objects.
    pub(super) fn configure_servers(&mut self) {
        for channel in self.channels.as_mut() {
            channel.configure(&self.device);
        }
        self.tell_servers();
    }

    /// Looks at their timers.
    pub(super) fn expire_servers(&mut self, now: Instant) {
        for channel in self.channels.as_mut() {
            channel.expire(now);
        }
        self.tell_servers();
    }

    /// When the first of their timers runs out.
    pub(super) fn servers_due(&self) -> Instant {
        let due = self.channels.as_ref().iter().map(Channel::due);
        due.fold(Instant::NEVER, Instant::min)
    }

    /// Ends their transfers without a word.
    pub(super) fn end_servers(&mut self) {
        self.channels.as_mut().iter_mut().for_each(Channel::reset);
        self.pending.remove(Pending::SERVERS);
    }

    /// Whether one of them has something to send.
    fn tell_servers(&mut self) {
        if self.channels.as_ref().iter().any(Channel::is_sending) {
            self.pending.add(Pending::SERVERS);
        } else {
            self.pending.remove(Pending::SERVERS);
        }
    }
}
