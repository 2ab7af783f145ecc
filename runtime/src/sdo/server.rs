//! The server's states and who acts in them.

use super::{
    block_download::BlockDownload,
    block_upload::BlockUpload,
    blocks::Terms,
    download::{self, Download},
    outgoing::Outgoing,
    upload::{self, Begun, Upload},
};
use crate::{
    od::{Device, Entry, Services},
    wire::sdo::{response, Request, Response, Segment},
    AbortCode, Address, Instant,
};

/// How long a client may leave a transfer open, in ms, unless [`Server::set_timeout`] says otherwise.
const TIMEOUT_MS: u32 = 1000;

/// An SDO server: one client's transfer at a time.
#[derive(Clone, Debug)]
pub struct Server<B> {
    pub(super) state: State,
    /// The value on its way.
    pub(super) buffer: B,
    /// When the open transfer is given up; [`Instant::NEVER`] without one, and while it is this side's turn.
    pub(super) due: Instant,
    timeout_ms: u32,
}

/// Which transfer is open. Each state has one function for each request that it awaits.
#[derive(Clone, Copy, Debug)]
pub(super) enum State {
    /// None: awaits `40` (upload), `2x` (download), `A0` (block upload) or `C0` (block download).
    Idle,
    /// Segments are coming in: awaits `0x` or `1x`.
    Download(Download),
    /// Segments are asked for: awaits `60` or `70`.
    Upload(Upload),
    /// Blocks are coming in: awaits segments, `01` to `FF`, and after them `C1`.
    BlockDownload(BlockDownload),
    /// Blocks are going out: awaits `A3`, then an `A2` for each block, then `A1`.
    BlockUpload(BlockUpload),
}

/// What there is to send after a request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Nothing.
    Nothing,
    /// One response.
    Response([u8; 8]),
    /// The segments of a block: [`Server::next_segment`] gives them one by one.
    Block,
}

/// A segment of a block, or what is sent in its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Next {
    /// The eight bytes.
    pub message: [u8; 8],
    /// Whether [`Server::next_segment`] has more.
    pub has_more: bool,
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

    /// Takes the eight bytes of a request; gives what there is to send.
    #[inline]
    pub fn receive<D: Device>(
        &mut self,
        now: Instant,
        device: &mut D,
        services: &mut impl Services,
        bytes: [u8; 8],
    ) -> Answer {
        if matches!(&self.state, State::BlockDownload(download) if !download.is_complete()) {
            return self.block_segment(now, device, bytes);
        }
        let response = match Request::parse(bytes) {
            Request::UploadInitiate { address } => self.upload(now, device, address),
            Request::DownloadExpedited { address, value } => {
                self.reset();
                download::expedited(device, services, address, value)
            }
            Request::DownloadSegment(segment) => self.download_segment(now, device, services, segment),
            Request::UploadSegment { toggle } => self.upload_segment(now, device, toggle),
            other => return self.receive_other(now, device, services, other),
        };
        Answer::Response(response)
    }

    /// The next segment of the block that is being sent; `None` when there is none.
    pub fn next_segment<D: Device>(&mut self, now: Instant, device: &mut D) -> Option<Next> {
        let State::BlockUpload(upload) = &mut self.state else {
            return None;
        };
        if !upload.is_sending() {
            return None;
        }
        let segment = upload.segment(device, self.buffer.as_mut());
        let has_more = segment.is_ok() && upload.is_sending();
        if !has_more {
            self.wait(now);
        }
        let message = match segment {
            Ok(segment) => segment,
            Err(code) => self.refuse(self.address(), code),
        };
        Some(Next { message, has_more })
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
    #[inline(never)]
    pub fn reset(&mut self) {
        self.state = State::Idle;
        self.due = Instant::NEVER;
    }

    /// What comes less often: all but reading, expedited writing, and segments.
    #[inline(never)]
    fn receive_other<D: Device>(
        &mut self,
        now: Instant,
        device: &mut D,
        services: &mut impl Services,
        request: Request,
    ) -> Answer {
        use Request as R;
        let address = match request {
            R::DownloadInitiate { address, .. }
            | R::BlockDownloadInitiate { address, .. }
            | R::BlockUploadInitiate { address, .. }
            | R::Unknown { address } => address,
            _ => self.address(),
        };
        let answer = match request {
            R::DownloadInitiate { size, .. } => self.download(now, device, address, size),
            R::BlockDownloadInitiate { size, crc, .. } => self.block_download(now, device, address, size, crc),
            R::BlockDownloadEnd { unused, crc } => self.block_download_end(device, services, unused, crc),
            R::BlockUploadInitiate {
                crc,
                block_size,
                threshold,
                ..
            } => self.block_upload(
                now,
                device,
                address,
                Terms {
                    crc,
                    block_size,
                    threshold,
                },
            ),
            R::BlockUploadStart => self.block_upload_start(),
            R::BlockUploadAcknowledge { sequence, block_size } => {
                self.block_upload_acknowledge(now, sequence, block_size)
            }
            R::BlockUploadEnd => self.block_upload_end(),
            R::Abort { .. } => {
                self.reset();
                Ok(Answer::Nothing)
            }
            _ => Err(AbortCode::UNKNOWN_COMMAND),
        };
        answer.unwrap_or_else(|code| Answer::Response(self.refuse(address, code)))
    }

    /// `40`: from any state to `Idle` with the value, or to `Upload`.
    #[inline]
    fn upload<D: Device>(&mut self, now: Instant, device: &mut D, address: Address) -> [u8; 8] {
        match upload::initiate(device, address) {
            Ok(Begun::Complete(value)) => {
                self.reset();
                Response::UploadExpedited { address, value }.emit()
            }
            Ok(Begun::Long(entry)) => self.upload_long(now, device, entry),
            Err(code) => self.refuse(address, code),
        }
    }

    #[inline(never)]
    fn upload_long<D: Device>(&mut self, now: Instant, device: &mut D, entry: Entry) -> [u8; 8] {
        match Outgoing::begin(device, self.buffer.as_mut(), entry, false) {
            Ok(outgoing) => self.begin_upload(now, device, outgoing),
            Err(code) => self.refuse(entry.address(), code),
        }
    }

    /// From any state to `Idle` if the value fits into the response, else to `Upload`.
    #[inline(never)]
    pub(super) fn begin_upload<D: Device>(&mut self, now: Instant, device: &mut D, mut outgoing: Outgoing) -> [u8; 8] {
        let address = outgoing.address();
        if let Some(value) = outgoing.expedited(device, self.buffer.as_mut()) {
            self.reset();
            return Response::UploadExpedited { address, value }.emit();
        }
        let size = outgoing.announced();
        self.enter(now, State::Upload(Upload::begin(outgoing)));
        Response::UploadInitiate { address, size }.emit()
    }

    /// `60` or `70`: stays in `Upload` until the last segment.
    #[inline(never)] // Reading and writing of short values is not to pay for it.
    fn upload_segment<D: Device>(&mut self, now: Instant, device: &mut D, toggle: bool) -> [u8; 8] {
        let State::Upload(upload) = &mut self.state else {
            return self.refuse(self.address(), AbortCode::UNKNOWN_COMMAND);
        };
        match upload.segment(device, self.buffer.as_mut(), toggle) {
            Ok(piece) => {
                self.proceed(now, piece.is_last);
                response::upload_segment(toggle, piece.is_last, piece.length, piece.bits)
            }
            Err(code) => self.refuse(self.address(), code),
        }
    }

    /// `20` or `21`: from any state to `Download`.
    fn download<D: Device>(
        &mut self,
        now: Instant,
        device: &mut D,
        address: Address,
        size: Option<u32>,
    ) -> Result<Answer, AbortCode> {
        let download = Download::begin(device, self.buffer.as_ref().len(), address, size)?;
        self.enter(now, State::Download(download));
        Ok(Answer::Response(Response::DownloadInitiate { address }.emit()))
    }

    /// `0x` or `1x`: stays in `Download` until the last segment.
    #[inline(never)]
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
                Response::DownloadSegment { toggle: segment.toggle }.emit()
            }
            Err(code) => self.refuse(self.address(), code),
        }
    }

    /// Opens a transfer.
    pub(super) fn enter(&mut self, now: Instant, state: State) {
        self.state = state;
        self.wait(now);
    }

    /// It is the client's turn.
    #[inline(never)]
    pub(super) fn wait(&mut self, now: Instant) {
        self.due = now.plus_millis(self.timeout_ms);
    }

    /// Leaves the transfer open, or ends it with its last segment.
    fn proceed(&mut self, now: Instant, last: bool) {
        if last {
            self.reset();
        } else {
            self.wait(now);
        }
    }

    /// Ends the transfer with an abort message.
    #[cold]
    #[inline(never)]
    pub(super) fn refuse(&mut self, address: Address, code: AbortCode) -> [u8; 8] {
        self.reset();
        Response::Abort { address, code }.emit()
    }

    /// What the open transfer is about; 0000h:00 without one.
    pub(super) fn address(&self) -> Address {
        match &self.state {
            State::Idle => Address::new(0, 0),
            State::Download(download) => download.incoming.address(),
            State::Upload(upload) => upload.outgoing.address(),
            State::BlockDownload(download) => download.incoming.address(),
            State::BlockUpload(upload) => upload.outgoing.address(),
        }
    }
}
