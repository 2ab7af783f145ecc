//! All PDOs of a device.

use super::{mpdo, sub, Direction, Parts, Room, Rpdo, Tpdo};
use crate::{
    od::{self, Device, Value},
    wire::{CanId, Frame},
    Address, Instant, NodeId,
};

/// The PDOs of a device, in the room that it has for them.
#[derive(Clone, Debug)]
pub struct Set<R> {
    room: R,
    /// OPERATIONAL.
    is_running: bool,
    /// Parameters of a PDO were written.
    is_stale: bool,
    /// Until when synchronous PDOs go with the last SYNC.
    window: Instant,
    due: Instant,
    /// TPDOs up to the last one that may be sent.
    used: usize,
}

/// The first RPDO of each kind that something is wrong with, by its number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Faults {
    /// Too short.
    pub short: Option<u16>,
    /// Not within its event timer.
    pub late: Option<u16>,
}

impl<R: Room> Set<R> {
    /// The PDOs that the dictionary has objects for, as many as there is room for. None is sent or received yet.
    #[must_use]
    pub fn new<D: Device>(device: &D, mut room: R) -> Self {
        let Parts { tpdos, rpdos, .. } = room.parts();
        let mut first = 0;
        for (tpdo, number) in tpdos.iter_mut().zip(present(device, Direction::Transmit)) {
            *tpdo = Tpdo::new(device, number, first);
            first = tpdo.end();
        }
        for (rpdo, number) in rpdos.iter_mut().zip(present(device, Direction::Receive)) {
            *rpdo = Rpdo::new(device, number, first);
            first = rpdo.end();
        }
        Self {
            room,
            is_running: false,
            is_stale: false,
            window: Instant::NEVER,
            due: Instant::NEVER,
            used: 0,
        }
    }

    /// All parameters may have changed, in a reset. Nothing is sent or received until the node is OPERATIONAL again.
    pub fn reset(&mut self) {
        self.stop();
        self.is_stale = true;
        let Parts { tpdos, rpdos, .. } = self.room.parts();
        tpdos.iter_mut().for_each(Tpdo::mark);
        rpdos.iter_mut().for_each(Rpdo::mark);
    }

    /// A client has written to the object at `index`: its PDO has new parameters.
    pub fn mark(&mut self, index: u16) {
        self.is_stale |= matches!(index, 0x1400..=0x1BFF);
        let number = super::parameter::number(index);
        let Parts { tpdos, rpdos, .. } = self.room.parts();
        match index {
            0x1400..=0x17FF => rpdos
                .iter_mut()
                .filter(|rpdo| rpdo.number() == number)
                .for_each(Rpdo::mark),
            0x1800..=0x1BFF => tpdos
                .iter_mut()
                .filter(|tpdo| tpdo.number() == number)
                .for_each(Tpdo::mark),
            _ => {}
        }
    }

    /// Takes parameters that were written, and starts or stops with the NMT state.
    pub fn configure<D: Device>(&mut self, now: Instant, device: &mut D, is_operational: bool) {
        if !self.is_stale && is_operational == self.is_running {
            return;
        }
        self.is_stale = false;
        let starts = is_operational && !self.is_running;
        if self.is_running && !is_operational {
            self.stop();
        }
        self.is_running = is_operational;
        let Parts { tpdos, rpdos, mapped } = self.room.parts();
        self.used = 0;
        for (nth, tpdo) in tpdos.iter_mut().enumerate() {
            if tpdo.configure(device, mapped) && is_operational || starts {
                tpdo.start(now, device, mapped);
            }
            if tpdo.id().is_some() {
                self.used = nth + 1;
            }
        }
        for rpdo in rpdos {
            rpdo.configure(device, mapped);
        }
        self.schedule(now);
    }

    /// A SYNC came, with a counter unless that is 0; its window ends at `window`. Says whether there is a TPDO to send.
    pub fn sync<D: Device>(&mut self, device: &mut D, counter: u8, window: Instant) -> bool {
        self.window = window;
        let Parts { tpdos, rpdos, mapped } = self.room.parts();
        for rpdo in rpdos {
            rpdo.sync(device, mapped);
        }
        let mut is_requested = false;
        for tpdo in tpdos.get_mut(..self.used).unwrap_or_default() {
            is_requested |= tpdo.sync(device, mapped, counter);
        }
        is_requested
    }

    /// Takes `frame` if it is an RPDO; says so. `node_id` is this node's.
    pub fn receive<D: Device>(
        &mut self,
        now: Instant,
        device: &mut D,
        node_id: NodeId,
        id: CanId,
        frame: &Frame,
    ) -> bool {
        let Parts { rpdos, mapped, .. } = self.room.parts();
        let Some(rpdo) = rpdos.iter_mut().find(|rpdo| rpdo.id() == Some(id)) else {
            return false;
        };
        if rpdo.is_multiplexed::<D>() {
            if frame.full_data().is_some() {
                rpdo.receive_multiplexed(device, node_id, frame);
            }
        } else if now <= self.window || !rpdo.is_synchronous() {
            rpdo.receive(now, device, mapped, frame);
            self.due = self.due.min(rpdo.due());
        }
        true
    }

    /// A remote frame asks for `id`. Says whether there is a TPDO to send.
    pub fn ask(&mut self, id: CanId) -> bool {
        self.first(|tpdo| tpdo.id() == Some(id)).is_some_and(|tpdo| {
            tpdo.ask();
            tpdo.is_requested()
        })
    }

    /// An event for the TPDO `number`. `false` when there is none, when it is not valid, or when its transmission type knows
    /// no events.
    pub fn trigger(&mut self, number: u16) -> bool {
        self.first(|tpdo| tpdo.number() == number).is_some_and(Tpdo::trigger)
    }

    /// A value for the object at `address` of `receiver`, or of all nodes, to be sent in a multiplexed PDO. `false` when there is
    /// no valid one with destination addressing, or it still has another value to send.
    pub fn send_to<D: Device>(&mut self, device: &D, receiver: Option<NodeId>, address: Address, value: u32) -> bool {
        self.multiplex(
            device,
            mpdo::DESTINATION,
            mpdo::to_destination(receiver, address, value),
        )
    }

    /// The object at `address` has changed: if a scanner list has it, it is sent in the multiplexed PDO with source
    /// addressing. `false` when it is not, or when that PDO still has another value to send.
    pub fn scan<D: Device>(&mut self, device: &mut D, node_id: NodeId, address: Address) -> bool {
        if !mpdo::is_scanned(device, address) {
            return false;
        }
        match od::read(device, address) {
            Ok(Value::Number { bits, data_type }) if data_type.length() <= 4 => {
                let value = mpdo::from_source(node_id, address, Value::Number { bits, data_type }.to_u32());
                self.multiplex(device, mpdo::SOURCE, value)
            }
            _ => false,
        }
    }

    fn multiplex<D: Device>(&mut self, device: &D, count: u8, word: u64) -> bool {
        let Parts { tpdos, .. } = self.room.parts();
        let mut tpdos = tpdos.iter_mut().filter(|tpdo| tpdo.is_multiplexed(device, count));
        tpdos.next().is_some_and(|tpdo| tpdo.multiplex(word))
    }

    /// An event for all TPDOs that carry the object at `address`. `false` when there is none.
    pub fn object_changed<D: Device>(&mut self, device: &D, address: Address) -> bool {
        let Parts { tpdos, mapped, .. } = self.room.parts();
        let mut is_triggered = false;
        for tpdo in tpdos {
            is_triggered |= tpdo.contains(device, mapped, address) && tpdo.trigger();
        }
        is_triggered
    }

    /// The TPDO to send at `now`, the one with the lowest identifier first; and whether there are more.
    pub fn send<D: Device>(&mut self, now: Instant, device: &mut D) -> (Option<Frame>, bool) {
        if now > self.window {
            self.miss();
        }
        let Parts { tpdos, mapped, .. } = self.room.parts();
        let mut next: Option<&mut Tpdo> = None;
        let (mut has_more, mut is_held) = (false, false);
        let tpdos = tpdos.get_mut(..self.used).unwrap_or_default();
        for tpdo in tpdos.iter_mut().filter(|tpdo| tpdo.is_requested()) {
            if !tpdo.may_be_sent(now) {
                is_held = true;
                continue;
            }
            has_more |= next.is_some();
            if next.as_ref().map_or(true, |next| tpdo.id() < next.id()) {
                next = Some(tpdo);
            }
        }
        let frame = next.and_then(|tpdo| {
            let frame = tpdo.send(device, mapped);
            if tpdo.has_timers() {
                tpdo.restart(now);
                self.due = self.due.min(tpdo.due(now));
            }
            frame
        });
        if is_held {
            self.schedule(now);
        }
        (frame, has_more)
    }

    /// Forgets synchronous transmissions that missed the window.
    #[cold]
    fn miss(&mut self) {
        let Parts { tpdos, .. } = self.room.parts();
        tpdos.iter_mut().for_each(Tpdo::miss);
    }

    /// Looks at the timers; says whether there is a TPDO to send.
    pub fn expire(&mut self, now: Instant) -> bool {
        if now < self.due {
            return false;
        }
        let Parts { tpdos, rpdos, .. } = self.room.parts();
        for rpdo in rpdos {
            rpdo.expire(now);
        }
        let mut is_requested = false;
        for tpdo in tpdos {
            is_requested |= tpdo.expire(now);
        }
        self.schedule(now);
        is_requested
    }

    /// When [`Set::expire`] has something to do; [`Instant::NEVER`] if no timer runs.
    #[must_use]
    pub const fn due(&self) -> Instant {
        self.due
    }

    /// What is wrong with RPDOs.
    pub fn faults(&mut self) -> Faults {
        let Parts { rpdos, .. } = self.room.parts();
        let first = |is_wrong: fn(&Rpdo) -> bool| rpdos.iter().find(|rpdo| is_wrong(rpdo)).map(Rpdo::number);
        Faults {
            short: first(Rpdo::is_short),
            late: first(Rpdo::is_late),
        }
    }

    /// The node left OPERATIONAL.
    #[inline(never)]
    pub fn stop(&mut self) {
        self.is_running = false;
        self.window = Instant::NEVER;
        self.due = Instant::NEVER;
        let Parts { tpdos, rpdos, .. } = self.room.parts();
        tpdos.iter_mut().for_each(Tpdo::stop);
        rpdos.iter_mut().for_each(Rpdo::stop);
    }

    fn first(&mut self, is_meant: impl Fn(&Tpdo) -> bool) -> Option<&mut Tpdo> {
        let Parts { tpdos, .. } = self.room.parts();
        tpdos.iter_mut().find(|tpdo| tpdo.number() != 0 && is_meant(tpdo))
    }

    /// Finds the first timer to run out.
    #[inline(never)]
    fn schedule(&mut self, now: Instant) {
        let Parts { tpdos, rpdos, .. } = self.room.parts();
        let mut due = Instant::NEVER;
        for tpdo in tpdos {
            due = due.min(tpdo.due(now));
        }
        for rpdo in rpdos {
            due = due.min(rpdo.due());
        }
        self.due = due;
    }
}

/// The numbers of the PDOs that have communication parameters.
fn present<D: Device>(device: &D, direction: Direction) -> impl Iterator<Item = u16> + '_ {
    (1..513).filter(move |&number| {
        let address = Address::new(direction.communication(number), sub::COB_ID);
        device.table().find(address).is_some()
    })
}
