//! The heartbeat consumer (object 1016h): which nodes are watched, and when each was heard last.
//!
//! ```text
//! 1016h:n written ──▶ not heard yet ── heartbeat ──▶ heard ── consumer heartbeat time ──▶ lost
//!                                                    ▲  │ heartbeat, boot-up              │
//!                                                    └──┘◀─────────── heartbeat ──────────┘
//! ```
//!
//! What CiA 301 leaves open: a boot-up message of a node that is being watched counts as a heartbeat, so that one which never
//! speaks again after its reset is missed; of a node that was not heard yet it does not start the watch.

use crate::{
    od::{self, Device},
    wire::nmt::NmtState,
    AbortCode, Address, Heard, Instant, NodeId,
};

/// 1016h:00: consumer heartbeat time, an ARRAY of UNSIGNED32: bits 16 to 23 the node-ID, bits 0 to 15 the time in ms.
pub const CONSUMER_HEARTBEAT_TIME: Address = Address::new(0x1016, 0x00);

/// A node that is watched: a sub-index of 1016h.
#[derive(Clone, Copy, Debug)]
pub struct Watch {
    /// `None` where nobody is to be watched.
    node_id: Option<NodeId>,
    /// In ms.
    time: u16,
    /// `None` until it is heard, and once it is lost.
    state: Option<NmtState>,
    is_lost: bool,
    due: Instant,
}

impl Watch {
    /// Nobody is watched.
    pub const NOBODY: Self = Self {
        node_id: None,
        time: 0,
        state: None,
        is_lost: false,
        due: Instant::NEVER,
    };

    /// What a value of 1016h asks for. A time or node-ID of 0 asks for nothing, as a node-ID above 127 does.
    fn new(value: u32) -> Self {
        let [t0, t1, node_id, _] = value.to_le_bytes();
        let time = u16::from_le_bytes([t0, t1]);
        Self {
            node_id: NodeId::new(node_id).filter(|_| time != 0),
            time,
            ..Self::NOBODY
        }
    }

    /// The same node, for the same time.
    fn is_alike(&self, other: &Self) -> bool {
        self.node_id == other.node_id && (self.time == other.time || self.node_id.is_none())
    }
}

/// The nodes that are watched, in the room that a device has for them: one [`Watch`] for each sub-index of 1016h.
#[derive(Clone, Debug)]
pub struct Consumers<R> {
    watches: R,
    due: Instant,
}

impl<R: AsMut<[Watch]> + AsRef<[Watch]>> Consumers<R> {
    /// Nobody is watched yet.
    pub const fn new(watches: R) -> Self {
        Self {
            watches,
            due: Instant::NEVER,
        }
    }

    /// Forgets whom it has heard.
    pub fn reset(&mut self) {
        self.watches.as_mut().fill(Watch::NOBODY);
        self.due = Instant::NEVER;
    }

    /// Looks at 1016h: a sub-index that has changed begins anew.
    pub fn configure<D: Device>(&mut self, device: &D) {
        for (sub, watch) in (1..=u8::MAX).zip(self.watches.as_mut()) {
            let wanted = Watch::new(od::parameter(device, consumer(sub)));
            if !watch.is_alike(&wanted) {
                *watch = wanted;
            }
        }
        self.schedule();
    }

    /// Takes what was heard of `node_id`; says what is new about it, if it is watched.
    pub fn receive(&mut self, now: Instant, node_id: NodeId, state: NmtState) -> Option<Heard> {
        let mut watches = self.watches.as_mut().iter_mut();
        let watch = watches.find(|watch| watch.node_id == Some(node_id))?;
        let is_boot_up = state == NmtState::Initialising;
        if watch.state.is_some() || !is_boot_up {
            watch.due = now.plus_millis(u32::from(watch.time));
            watch.is_lost = false;
        }
        if is_boot_up {
            return Some(Heard::BootUp);
        }
        let is_new = watch.state.replace(state) != Some(state);
        self.schedule();
        is_new.then_some(Heard::State(state))
    }

    /// The next node whose time ran out before `now`.
    pub fn expire(&mut self, now: Instant) -> Option<NodeId> {
        let late = self.watches.as_mut().iter_mut().find(|watch| now >= watch.due)?;
        (late.due, late.state, late.is_lost) = (Instant::NEVER, None, true);
        let node_id = late.node_id;
        self.schedule();
        node_id
    }

    /// When [`Consumers::expire`] has something to say; [`Instant::NEVER`] while nobody is heard.
    #[inline]
    #[must_use]
    pub const fn due(&self) -> Instant {
        self.due
    }

    /// A node that was heard and is no more.
    #[must_use]
    pub fn lost(&self) -> Option<NodeId> {
        let mut watches = self.watches.as_ref().iter();
        watches.find(|watch| watch.is_lost).and_then(|watch| watch.node_id)
    }

    fn schedule(&mut self) {
        let due = self.watches.as_ref().iter().map(|watch| watch.due);
        self.due = due.fold(Instant::NEVER, Instant::min);
    }
}

/// Refuses what a client may not write to 1016h; says nothing of other objects.
///
/// # Errors
/// [`AbortCode::PARAMETER_INCOMPATIBLE`] for a node that another sub-index watches already (CiA 301, 7.5.2.19).
pub fn before_write<D: Device>(device: &D, address: Address, value: u32) -> Result<(), AbortCode> {
    if address.index != CONSUMER_HEARTBEAT_TIME.index {
        return Ok(());
    }
    let Some(node_id) = Watch::new(value).node_id else {
        return Ok(());
    };
    let watches = |sub| Watch::new(od::parameter(device, consumer(sub))).node_id;
    let mut others = (1..=127).filter(|sub| *sub != address.sub);
    if others.any(|sub| watches(sub) == Some(node_id)) {
        return Err(AbortCode::PARAMETER_INCOMPATIBLE);
    }
    Ok(())
}

const fn consumer(sub: u8) -> Address {
    Address::new(CONSUMER_HEARTBEAT_TIME.index, sub)
}
