//! The server's states and who acts in them.

use super::{
    download::{self, Download},
    upload::{self, Upload},
};
use crate::{
    od::{Device, Services},
    wire::sdo::{Request, Response},
    AbortCode, Address, Instant,
};

/// How long a client may leave a transfer open, in ms, unless [`Server::set_timeout`] says otherwise.
const TIMEOUT_MS: u32 = 1000;

/// An SDO server: one client's transfer at a time.
#[derive(Clone, Debug)]
pub struct Server<B> {
    state: State,
    /// The value on its way.
    buffer: B,
    /// When the open transfer is given up; [`Instant::NEVER`] without one.
    due: Instant,
    timeout_ms: u32,
}

/// Which transfer is open. Each state has one function, which takes a request and gives the next state.
#[derive(Clone, Copy, Debug)]
pub(super) enum State {
    /// None: awaits `40` (upload) or `2x` (download).
    Idle,
    /// Segments are coming in: awaits `0x` or `1x`.
    Download(Download),
    /// Segments are asked for: awaits `60` or `70`.
    Upload(Upload),
}

/// The next state, and what to answer.
pub(super) type Step = (State, Response);

impl<B: AsRef<[u8]> + AsMut<[u8]>> Server<B> {
    /// A server without a transfer, which collects values in `buffer`.
    pub const fn new(buffer: B) -> Self {
        Self {
            state: State::Idle,
            buffer,
            due: Instant::NEVER,
            timeout_ms: TIMEOUT_MS,
        }
    }

    /// Sets how long a client may leave a transfer open, in ms.
    pub fn set_timeout(&mut self, timeout_ms: u32) {
        self.timeout_ms = timeout_ms;
    }

    /// Takes the eight bytes of a request; gives the answer, if there is one.
    #[inline]
    pub fn receive<D: Device>(
        &mut self,
        now: Instant,
        device: &mut D,
        services: &mut impl Services,
        bytes: [u8; 8],
    ) -> Option<[u8; 8]> {
        let (state, response) = match Request::parse(bytes) {
            Request::UploadInitiate { address } => upload::initiate(device, self.buffer.as_mut(), address),
            Request::DownloadExpedited { address, value } => {
                (State::Idle, download::expedited(device, services, address, value))
            }
            Request::Abort { .. } => {
                self.reset();
                return None;
            }
            request => self.continue_transfer(device, services, request),
        };
        self.enter(now, state);
        Some(response.emit())
    }

    /// Gives the transfer up if it has been left open for too long: then there is an abort message to send.
    pub fn expire(&mut self, now: Instant) -> Option<[u8; 8]> {
        if now < self.due {
            return None;
        }
        let address = self.address();
        self.reset();
        let code = AbortCode::TIMED_OUT;
        Some(Response::Abort { address, code }.emit())
    }

    /// When [`Server::expire`] has something to do; [`Instant::NEVER`] without a transfer.
    #[inline]
    #[must_use]
    pub const fn due(&self) -> Instant {
        self.due
    }

    /// Ends the transfer without a word.
    pub fn reset(&mut self) {
        self.state = State::Idle;
        self.due = Instant::NEVER;
    }

    /// What is rarer than an expedited transfer.
    fn continue_transfer<D: Device>(&mut self, device: &mut D, services: &mut impl Services, request: Request) -> Step {
        match (self.state, request) {
            (_, Request::DownloadInitiate { address, size }) => {
                download::initiate(device, self.buffer.as_ref().len(), address, size)
            }
            (State::Download(download), Request::DownloadSegment(segment)) => {
                download.segment(device, services, self.buffer.as_mut(), segment)
            }
            (State::Upload(upload), Request::UploadSegment { toggle }) => {
                upload.segment(device, self.buffer.as_ref(), toggle)
            }
            (_, Request::Unknown { address }) => refuse(address, AbortCode::UNKNOWN_COMMAND),
            _ => refuse(self.address(), AbortCode::UNKNOWN_COMMAND),
        }
    }

    fn enter(&mut self, now: Instant, state: State) {
        self.due = match state {
            State::Idle => Instant::NEVER,
            State::Download(_) | State::Upload(_) => now.plus_millis(self.timeout_ms),
        };
        self.state = state;
    }

    /// What the open transfer is about.
    fn address(&self) -> Address {
        match self.state {
            State::Idle => Address::new(0, 0),
            State::Download(download) => download.address(),
            State::Upload(upload) => upload.address(),
        }
    }
}

/// Ends the transfer with an abort message.
pub(super) fn refuse(address: Address, code: AbortCode) -> Step {
    (State::Idle, Response::Abort { address, code })
}
