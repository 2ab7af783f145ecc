//! A server beyond the first, and the identifiers that it is spoken to by.

use super::{
    parameter::{cob_id, CLIENT_TO_SERVER, SERVER_TO_CLIENT},
    server::{Answer, Server, State},
};
use crate::{
    od::{self, Device, Services},
    wire::{CanId, Frame},
    Address, Instant,
};

/// A server beyond the first: 1201h to 127Fh. It has a transfer of its own, on identifiers of its own.
#[derive(Clone, Debug)]
pub struct Channel<B> {
    server: Server<B>,
    /// The object of its parameters; 0 of room that no object is for.
    index: u16,
    /// `None` while its object does not make it valid.
    connection: Option<Connection>,
    /// The response that waits to be sent. It has its identifier already: a client that takes its own server away is answered
    /// where it asked.
    response: Option<Frame>,
}

/// The identifiers of the two directions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Connection {
    request: CanId,
    response: CanId,
}

impl<const N: usize> Channel<[u8; N]> {
    /// A server that no object is for yet.
    pub const IDLE: Self = Self::new([0; N]);
}

impl<B: AsRef<[u8]> + AsMut<[u8]>> Channel<B> {
    /// A server that no object is for yet; it collects values in `buffer`.
    pub const fn new(buffer: B) -> Self {
        Self {
            server: Server::new(buffer),
            index: 0,
            connection: None,
            response: None,
        }
    }

    /// Gives each of `channels` an object of the dictionary, in their order.
    pub(crate) fn assign<D: Device<Buffer = B>>(device: &D, channels: &mut [Self]) {
        let has_server = |index: &u16| od::configured(device, Address::new(*index, CLIENT_TO_SERVER)).is_some();
        for (channel, index) in channels.iter_mut().zip((0x1201..=0x127F).filter(has_server)) {
            channel.index = index;
        }
    }

    /// Looks at the object. Other identifiers than before end the transfer without a word.
    pub(crate) fn configure<D: Device>(&mut self, device: &D) {
        let connection = Connection::configured(device, self.index);
        if connection != self.connection {
            self.server.reset();
            self.connection = connection;
        }
    }

    /// Whether requests with this identifier are for it.
    pub(crate) fn is_asked(&self, id: CanId) -> bool {
        self.connection.is_some_and(|connection| connection.request == id)
    }

    /// Takes the eight bytes of a request. The answer to the one before it is stale then.
    pub(crate) fn receive<D: Device>(
        &mut self,
        now: Instant,
        device: &mut D,
        services: &mut impl Services,
        request: [u8; 8],
    ) {
        self.response = match self.server.receive(now, device, services, request) {
            Answer::Response(response) => self.frame(response),
            Answer::Block | Answer::Nothing => None,
        };
    }

    /// Whether it has something to send.
    pub(crate) fn is_sending(&self) -> bool {
        self.response.is_some() || matches!(&self.server.state, State::BlockUpload(upload) if upload.is_sending())
    }

    /// The response that waits, if there is one.
    pub(crate) fn send_response(&mut self) -> Option<Frame> {
        self.response.take()
    }

    /// The next segment of a block, if one is being sent.
    pub(crate) fn send_segment<D: Device>(&mut self, now: Instant, device: &mut D) -> Option<Frame> {
        let next = self.server.next_segment(now, device)?;
        self.frame(next.message)
    }

    /// Gives the transfer up, with an abort message, if it has been left open for too long.
    pub(crate) fn expire(&mut self, now: Instant) {
        if let Some(abort) = self.server.expire(now) {
            self.response = self.frame(abort);
        }
    }

    /// When [`Channel::expire`] has something to do; [`Instant::NEVER`] without a transfer.
    pub(crate) const fn due(&self) -> Instant {
        self.server.due()
    }

    /// Sets how long a client may leave a transfer open, in ms.
    pub(crate) fn set_timeout(&mut self, timeout_ms: u32) {
        self.server.set_timeout(timeout_ms);
    }

    /// Ends the transfer without a word.
    pub(crate) fn reset(&mut self) {
        self.server.reset();
        self.response = None;
    }

    fn frame(&self, message: [u8; 8]) -> Option<Frame> {
        self.connection
            .map(|connection| Frame::full(connection.response, message))
    }
}

impl Connection {
    /// What the object at `index` says: a connection once both directions are valid (CiA 301, 7.5.2.33).
    fn configured<D: Device>(device: &D, index: u16) -> Option<Self> {
        let id = |sub| {
            Some(cob_id(device, Address::new(index, sub)))
                .filter(|id| id.is_valid())?
                .can_id()
        };
        Some(Self {
            request: id(CLIENT_TO_SERVER)?,
            response: id(SERVER_TO_CLIENT)?,
        })
    }
}
