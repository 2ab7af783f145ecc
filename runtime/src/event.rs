//! What a node tells its application.

use crate::{
    lss::BitRate,
    od::{Reset, TimeOfDay},
    storage::Group,
    wire::nmt::NmtState,
    Address, NodeId,
};

/// Something that happened on the bus or to the node, other than an access to an object.
///
/// An application gets it by the method `event` of its generated `Handlers`; there it may change fields of the dictionary.
/// New events come with new services, so a `match` needs an arm for the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Event {
    /// The node has entered this NMT state. INITIALISING is not told: [`Event::Reset`] is.
    State(NmtState),
    /// The node was reset: values that a client may write have their values after power-on again, what the application
    /// alone writes is the application's to reset. The boot-up message follows, then [`Event::State`].
    Reset(Reset),
    /// What was heard, or not heard any more, of a node whose heartbeat is watched (1016h).
    Heartbeat {
        /// That node.
        node_id: NodeId,
        /// What is new about it.
        heard: Heard,
    },
    /// The NMT master has stopped asking for this node's state (`true`), or has begun again (`false`): life guarding, by
    /// 100Ch and 100Dh.
    LifeGuardingLost(bool),
    /// The stored value of this object does not fit the dictionary any more, and is not loaded: the object is not there or not
    /// stored, or its length or limits are others.
    Dropped(Address),
    /// A client has saved the parameters of this group (1010h).
    Saved(Group),
    /// A client has restored the default parameters of this group (1011h): they count after the next reset.
    Restored(Group),
    /// The CAN controller is to have this bit rate from now on: LSS was told to activate it. The node is silent for the
    /// switch delay that follows.
    BitRate(BitRate),
    /// The time of day, from a TIME message (1012h).
    Time(TimeOfDay),
}

/// What is new about another node's heartbeat.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Heard {
    /// A heartbeat with another state than before, or the first one.
    State(NmtState),
    /// A boot-up message: the node has been reset, or switched on.
    BootUp,
    /// No heartbeat for the consumer heartbeat time.
    Nothing,
}
