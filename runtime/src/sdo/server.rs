//! The server's states and who acts in them.

use super::{
    download::{self, Download},
    upload::{self, Begun, Upload},
};
use crate::{
    od::{Device, Services},
    wire::sdo::{Request, Response, Segment},
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

/// Which transfer is open. Each state has one function, which takes a request and says whether the transfer goes on.
#[derive(Clone, Copy, Debug)]
enum State {
    /// None: awaits `40` (upload) or `2x` (download).
    Idle,
    /// Segments are coming in: awaits `0x` or `1x`.
    Download(Download),
    /// Segments are asked for: awaits `60` or `70`.
    Upload(Upload),
}

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
        let response = match Request::parse(bytes) {
            Request::UploadInitiate { address } => self.upload(now, device, address),
            Request::DownloadExpedited { address, value } => {
                self.reset();
                download::expedited(device, services, address, value)
            }
            Request::DownloadSegment(segment) => self.download_segment(now, device, services, segment),
            Request::UploadSegment { toggle } => self.upload_segment(now, device, toggle),
            Request::DownloadInitiate { address, size } => self.download(now, device, address, size),
            Request::Unknown { address } => self.refuse(address, AbortCode::UNKNOWN_COMMAND),
            Request::Abort { .. } => {
                self.reset();
                return None;
            }
        };
        Some(response)
    }

    /// Gives the transfer up if it has been left open for too long: then there is an abort message to send.
    pub fn expire(&mut self, now: Instant) -> Option<[u8; 8]> {
        if now < self.due {
            return None;
        }
        Some(self.refuse(self.address(), AbortCode::TIMED_OUT))
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

    /// `40`: from any state to `Idle` with the value, or to `Upload`.
    #[inline]
    fn upload<D: Device>(&mut self, now: Instant, device: &mut D, address: Address) -> [u8; 8] {
        match upload::initiate(device, self.buffer.as_mut(), address) {
            Ok(Begun::Complete(value)) => {
                self.reset();
                Response::UploadExpedited { address, value }.emit()
            }
            Ok(Begun::Segmented(upload)) => {
                self.enter(now, State::Upload(upload));
                let size = upload.size();
                Response::UploadInitiate { address, size }.emit()
            }
            Err(code) => self.refuse(address, code),
        }
    }

    /// `60` or `70`: stays in `Upload` until the last segment.
    fn upload_segment<D: Device>(&mut self, now: Instant, device: &D, toggle: bool) -> [u8; 8] {
        let State::Upload(upload) = &mut self.state else {
            return self.refuse(self.address(), AbortCode::UNKNOWN_COMMAND);
        };
        match upload.segment(device, self.buffer.as_ref(), toggle) {
            Ok(segment) => {
                self.proceed(now, segment.last);
                Response::UploadSegment(segment).emit()
            }
            Err(code) => self.refuse(self.address(), code),
        }
    }

    /// `20` or `21`: from any state to `Download`.
    fn download<D: Device>(&mut self, now: Instant, device: &D, address: Address, size: Option<u32>) -> [u8; 8] {
        match Download::new(device, self.buffer.as_ref().len(), address, size) {
            Ok(download) => {
                self.enter(now, State::Download(download));
                Response::DownloadInitiate { address }.emit()
            }
            Err(code) => self.refuse(address, code),
        }
    }

    /// `0x` or `1x`: stays in `Download` until the last segment.
    fn download_segment<D: Device>(
        &mut self,
        now: Instant,
        device: &mut D,
        services: &mut impl Services,
        segment: Segment,
    ) -> [u8; 8] {
        let State::Download(download) = &mut self.state else {
            return self.refuse(self.address(), AbortCode::UNKNOWN_COMMAND);
        };
        match download.segment(device, services, self.buffer.as_mut(), segment) {
            Ok(()) => {
                self.proceed(now, segment.last);
                let toggle = segment.toggle;
                Response::DownloadSegment { toggle }.emit()
            }
            Err(code) => self.refuse(self.address(), code),
        }
    }

    /// Opens a transfer.
    fn enter(&mut self, now: Instant, state: State) {
        self.state = state;
        self.due = now.plus_millis(self.timeout_ms);
    }

    /// Leaves the transfer open, or ends it with its last segment.
    fn proceed(&mut self, now: Instant, last: bool) {
        if last {
            self.reset();
        } else {
            self.due = now.plus_millis(self.timeout_ms);
        }
    }

    /// Ends the transfer with an abort message.
    #[cold]
    fn refuse(&mut self, address: Address, code: AbortCode) -> [u8; 8] {
        self.reset();
        Response::Abort { address, code }.emit()
    }

    /// What the open transfer is about; 0000h:00 without one.
    fn address(&self) -> Address {
        match &self.state {
            State::Idle => Address::new(0, 0),
            State::Download(download) => download.address(),
            State::Upload(upload) => upload.address(),
        }
    }
}
