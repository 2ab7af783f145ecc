//! The client over a transport, one call a transfer.

use std::time::{Duration, Instant as Wall};

use lexican_runtime::{Address, Instant};

use super::{Client, Failure, Manner};
use crate::transport::{Error, Transport};

/// The time since it was made, as the protocol's parts count it.
#[derive(Clone, Copy, Debug)]
pub struct Clock(Wall);

impl Clock {
    /// A clock that begins now.
    #[must_use]
    pub fn start() -> Self {
        Self(Wall::now())
    }

    /// The time since it began, in µs.
    #[must_use]
    pub fn now(&self) -> Instant {
        Instant::from_micros(u64::try_from(self.0.elapsed().as_micros()).unwrap_or(u64::MAX))
    }
}

/// Reads the value at `address`, and waits for it.
///
/// # Errors
/// The outer one when the bus is gone, the inner one when the node does not give the value.
pub fn upload(
    transport: &mut impl Transport,
    client: &mut Client,
    address: Address,
    manner: Manner,
) -> Result<Result<Vec<u8>, Failure>, Error> {
    let clock = Clock::start();
    client.upload(clock.now(), address, manner);
    finish(transport, client, clock)
}

/// Writes `value` to `address`, and waits for the confirmation.
///
/// # Errors
/// The outer one when the bus is gone, the inner one when the node does not take the value.
pub fn download(
    transport: &mut impl Transport,
    client: &mut Client,
    address: Address,
    value: Vec<u8>,
    manner: Manner,
) -> Result<Result<(), Failure>, Error> {
    let clock = Clock::start();
    client.download(clock.now(), address, value, manner);
    Ok(finish(transport, client, clock)?.map(drop))
}

/// Lets frames through until the transfer is over. Every wait ends: the client's own does, and the transport's is as long.
fn finish(
    transport: &mut impl Transport,
    client: &mut Client,
    clock: Clock,
) -> Result<Result<Vec<u8>, Failure>, Error> {
    loop {
        while let Some(frame) = client.poll(clock.now()) {
            transport.send(&frame)?;
        }
        if let Some(outcome) = client.outcome() {
            return Ok(outcome);
        }
        if let Some(frame) = transport.receive(patience(client, clock))? {
            client.receive(clock.now(), &frame);
        }
    }
}

/// Until the client is to be polled.
fn patience(client: &Client, clock: Clock) -> Duration {
    let due = client.poll_at().map_or(0, Instant::as_micros);
    Duration::from_micros(due.saturating_sub(clock.now().as_micros()))
}
