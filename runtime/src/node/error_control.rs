//! Who is alive: heartbeats of others, node guarding, and what an error does to the NMT state.

use super::{Node, Pending};
use crate::{
    guarding,
    od::{self, Device, ServiceSet},
    wire::{
        self,
        emcy::Emergency,
        nmt::{NmtCommand, NmtState},
        CanId, Frame,
    },
    Address, BusState, Event, Heard, Instant,
};

/// 1029h: error behaviour, an ARRAY of UNSIGNED8; sub-index 1 is for errors of communication.
const ERROR_BEHAVIOUR: u16 = 0x1029;
/// 1F80h: NMT start-up, UNSIGNED32.
const START_UP: Address = Address::new(0x1F80, 0x00);

impl<D: Device> Node<D> {
    /// Does what an error of `class` does to the NMT state, as 1029h:`class` says (CiA 301, 7.5.2.28): 1 for communication,
    /// from 2 on the device profile's and the manufacturer's. Without that object, or when it is 0, an OPERATIONAL node
    /// goes PRE-OPERATIONAL; 1 changes nothing, 2 stops the node.
    ///
    /// The node does so itself for class 1, when a watched heartbeat or node guarding ceases, and when the bus is off.
    pub fn react_to_error(&mut self, class: u8) {
        let behaviour = if D::SERVICES.has(ServiceSet::ERROR_BEHAVIOUR) {
            od::parameter(&self.device, Address::new(ERROR_BEHAVIOUR, class))
        } else {
            0
        };
        match behaviour {
            0 if self.nmt.exchanges_pdos() => self.obey(NmtCommand::EnterPreOperational),
            2 => self.obey(NmtCommand::Stop),
            _ => {}
        }
    }

    /// Tells the node the state of the CAN controller, as often as the driver likes. What is new is told in emergency
    /// messages, 8120h for error passive and 8140h after the bus was off; and the bus being off is an error of class 1
    /// ([`Node::react_to_error`]).
    ///
    /// While the bus is off nothing can be sent: what [`Node::poll`] gives then is lost.
    pub fn set_bus_state(&mut self, state: BusState) {
        let before = core::mem::replace(&mut self.bus_state, state);
        if before == state {
            return;
        }
        let passive = Emergency::new(Emergency::CAN_PASSIVE, Emergency::COMMUNICATION);
        self.report(passive, state == BusState::Passive);
        if state == BusState::Off {
            self.react_to_error(1);
        } else if before == BusState::Off {
            self.mention(Emergency::BUS_OFF_RECOVERED);
        }
    }

    /// The state of the CAN controller, as [`Node::set_bus_state`] told it last.
    #[must_use]
    pub const fn bus_state(&self) -> BusState {
        self.bus_state
    }

    /// The driver has lost frames: they came faster than they were taken. An emergency message says so, 8110h.
    pub fn report_overrun(&mut self) {
        self.mention(Emergency::CAN_OVERRUN);
    }

    /// An error of communication that is over as soon as it is told.
    fn mention(&mut self, code: u16) {
        self.raise_emergency(Emergency::new(code, Emergency::COMMUNICATION));
        self.clear_emergency(code);
    }

    /// Takes a frame that may be another node's heartbeat, or ask for the state of this one; says whether it was.
    pub(super) fn receive_error_control(&mut self, now: Instant, frame: &Frame) -> bool {
        if frame.is_remote() {
            let is_asked = self.is_guarded() && frame.id() == CanId::error_control(self.id);
            if is_asked {
                self.pending.add(Pending::GUARDING);
            }
            return is_asked;
        }
        if !D::SERVICES.has(ServiceSet::HEARTBEAT_CONSUMER) {
            return false;
        }
        let Some((node_id, state)) = wire::heartbeat::parse(frame) else {
            return false;
        };
        if let Some(heard) = self.consumers.receive(now, node_id, state) {
            self.device.event(Event::Heartbeat { node_id, heard });
            self.pending.add(Pending::CONFIGURATION);
        }
        self.report_lost();
        self.schedule();
        true
    }

    /// Whether the master may ask for the state. A heartbeat producer is not guarded (CiA 301, 7.2.8.2.2).
    fn is_guarded(&self) -> bool {
        D::SERVICES.has(ServiceSet::NODE_GUARDING)
            && od::number(&self.device, guarding::GUARD_TIME).is_some()
            && self.heartbeat_time() == 0
            && self.nmt.state() != NmtState::Initialising
    }

    /// The answer to the master's question.
    pub(super) fn send_guarding(&mut self, now: Instant) -> Frame {
        let was_alone = self.guarding.is_alone();
        let byte = self.guarding.answer(now, &self.device, self.nmt.state());
        if was_alone {
            self.tell_alone(false);
        }
        self.schedule();
        Frame::byte(CanId::error_control(self.id), byte)
    }

    /// Looks at 1016h, 100Ch and 100Dh.
    pub(super) fn configure_error_control(&mut self) {
        if D::SERVICES.has(ServiceSet::HEARTBEAT_CONSUMER) {
            self.consumers.configure(&self.device);
        }
        if D::SERVICES.has(ServiceSet::NODE_GUARDING) {
            self.guarding.configure(&self.device);
        }
        self.report_lost();
    }

    /// Looks at the timers.
    pub(super) fn expire_error_control(&mut self, now: Instant) {
        if D::SERVICES.has(ServiceSet::HEARTBEAT_CONSUMER) {
            while let Some(node_id) = self.consumers.expire(now) {
                let heard = Heard::Nothing;
                self.device.event(Event::Heartbeat { node_id, heard });
                self.report_lost();
                self.react_to_error(1);
            }
        }
        if D::SERVICES.has(ServiceSet::NODE_GUARDING) && now >= self.guarding.due() {
            self.guarding.expire(now);
            self.tell_alone(true);
            self.react_to_error(1);
        }
    }

    fn tell_alone(&mut self, is_alone: bool) {
        self.device.event(Event::LifeGuardingLost(is_alone));
        self.pending.add(Pending::CONFIGURATION);
        self.report_lost();
    }

    /// Raises 8130h while a node that is watched or the master is missing, and clears it. The first byte of the manufacturer
    /// is that node's ID; 0 for the master.
    fn report_lost(&mut self) {
        if !D::SERVICES.has(ServiceSet::HEARTBEAT_CONSUMER.with(ServiceSet::NODE_GUARDING)) {
            return;
        }
        let lost = self.consumers.lost();
        let node_id = lost.map_or(0, crate::NodeId::get);
        let emergency = Emergency::new(Emergency::LIFE_GUARD, Emergency::COMMUNICATION).with([node_id, 0, 0, 0, 0]);
        self.report(emergency, lost.is_some() || self.guarding.is_alone());
    }

    /// What 1F80h says about the time after the boot-up message (CiA 302-2; the meanings are those of the encoders'
    /// manuals): bit 3 for OPERATIONAL at once, bit 1 for that and starting all other nodes too.
    pub(super) fn start_up(&mut self) {
        if !D::SERVICES.has(ServiceSet::START_UP) {
            return;
        }
        let behaviour = od::parameter(&self.device, START_UP);
        if behaviour & 0x02 != 0 {
            self.pending.add(Pending::START_ALL);
        }
        if behaviour & 0x0A != 0 {
            self.obey(NmtCommand::Start);
        }
    }
}
