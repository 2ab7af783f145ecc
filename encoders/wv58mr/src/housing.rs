//! The whole device: two encoders in one housing, on one bus.

use lexican_runtime::{Frame, Instant, profile::encoder::Sensor, storage::Storage};

use crate::{
    WrongSensor,
    encoder::Encoder,
    variant::{Channel, Identity, Model},
};

/// Both encoders of a housing: nodes 1 and 2 as delivered, each with a sensor, a dictionary and an EEPROM of its own.
///
/// What they share is the bus: each hears what the other sends.
pub struct Housing<S: Sensor, M: Storage> {
    encoders: [Encoder<S, M>; 2],
}

impl<S: Sensor, M: Storage> Housing<S, M> {
    /// Both encoders after power-on: for each its sensor and its EEPROM; and the serial number that is imprinted on the
    /// housing.
    ///
    /// # Errors
    /// [`WrongSensor`] for a sensor that none of the encoders has.
    pub fn new(model: Model, imprinted: u32, first: (S, M), second: (S, M)) -> Result<Self, WrongSensor> {
        let encoder = |channel, (sensor, storage)| {
            let identity = Identity {
                model,
                channel,
                imprinted,
            };
            Encoder::with_storage(sensor, identity, storage)
        };
        Ok(Self {
            encoders: [encoder(Channel::First, first)?, encoder(Channel::Second, second)?],
        })
    }

    /// Both take a frame from the bus.
    pub fn receive(&mut self, now: Instant, frame: &Frame) {
        for encoder in &mut self.encoders {
            encoder.receive(now, frame);
        }
    }

    /// The next frame that one of them sends at `now`, after the other has heard it; `None` when there is nothing (more) to
    /// say.
    pub fn poll(&mut self, now: Instant) -> Option<Frame> {
        let [first, second] = &mut self.encoders;
        if let Some(frame) = first.poll(now) {
            second.receive(now, &frame);
            return Some(frame);
        }
        let frame = second.poll(now)?;
        first.receive(now, &frame);
        Some(frame)
    }

    /// When [`Housing::poll`] is to be called next, if no frame arrives before.
    #[must_use]
    pub fn poll_at(&self) -> Option<Instant> {
        let [first, second] = self.encoders.each_ref().map(Encoder::poll_at);
        first.into_iter().chain(second).min()
    }

    /// One of them.
    #[must_use]
    pub const fn encoder(&self, channel: Channel) -> &Encoder<S, M> {
        let [first, second] = &self.encoders;
        match channel {
            Channel::First => first,
            Channel::Second => second,
        }
    }

    /// One of them, to drive.
    pub fn encoder_mut(&mut self, channel: Channel) -> &mut Encoder<S, M> {
        let [first, second] = &mut self.encoders;
        match channel {
            Channel::First => first,
            Channel::Second => second,
        }
    }
}
