//! Heartbeats (CiA 301, 7.2.8.3.2.2): a node tells its state at regular intervals ([`Producer`], 1017h), and watches whether
//! others do ([`Consumers`], 1016h).

mod consumer;
mod producer;

pub use consumer::{before_write, Consumers, Watch, CONSUMER_HEARTBEAT_TIME};
pub use producer::{Producer, PRODUCER_HEARTBEAT_TIME};
