//! One attempt at a transfer, of whichever kind.

use lexican_runtime::{
    AbortCode, Address,
    wire::sdo::{BlockSegment, Request, Response},
};

use super::{block_download::BlockDownload, block_upload::BlockUpload, download::Download, step::Step, upload::Upload};

/// From how many bytes on blocks need fewer messages, even when the plain transfer has to be given up first.
pub(super) const BLOCKS_PAY: u32 = 64;

/// What is to be done.
#[derive(Clone, Debug)]
pub(super) struct Job {
    pub(super) address: Address,
    /// The value to be written; `None` to read.
    pub(super) value: Option<Vec<u8>>,
}

/// How an attempt begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Opening {
    Plain,
    /// Plain, and blocks as soon as they pay.
    Adaptive,
    Block,
}

/// A transfer under way.
#[derive(Clone, Debug)]
pub(super) struct Attempt {
    address: Address,
    kind: Kind,
    /// The last answer that counted: the same once more is a repetition.
    previous: Option<[u8; 8]>,
}

#[derive(Clone, Debug)]
enum Kind {
    Upload(Upload),
    BlockUpload(BlockUpload),
    Download(Download),
    BlockDownload(BlockDownload),
}

impl Attempt {
    /// Begins, and the request to send.
    pub(super) fn open(job: &Job, opening: Opening) -> (Self, [u8; 8]) {
        let (kind, request) = open(job, opening);
        let attempt = Self {
            address: job.address,
            kind,
            previous: None,
        };
        (attempt, request.emit())
    }

    /// Takes eight bytes from the server.
    pub(super) fn receive(&mut self, bytes: [u8; 8]) -> Step {
        if let Some(step) = self.on_abort(bytes) {
            return step;
        }
        if self.previous == Some(bytes) && !self.may_repeat(bytes) {
            return Step::PassOver;
        }
        let step = match &mut self.kind {
            Kind::Upload(upload) => upload.receive(Response::parse(bytes)),
            Kind::BlockUpload(upload) => upload.receive(bytes),
            Kind::Download(download) => download.receive(Response::parse(bytes)),
            Kind::BlockDownload(download) => download.receive(Response::parse(bytes)),
        };
        if step != Step::PassOver {
            self.previous = Some(bytes);
        }
        step
    }

    /// What is to be said when the answer stays out; `None` to give up.
    pub(super) fn on_silence(&mut self) -> Option<Step> {
        match &mut self.kind {
            Kind::BlockUpload(upload) => upload.on_silence(),
            _ => None,
        }
    }

    /// What the client waits for, as it follows on "no".
    pub(super) const fn awaited(&self) -> &'static str {
        match &self.kind {
            Kind::Upload(upload) => upload.awaited(),
            Kind::BlockUpload(upload) => upload.awaited(),
            Kind::Download(download) => download.awaited(),
            Kind::BlockDownload(download) => download.awaited(),
        }
    }

    /// Whether blocks were asked for, and the server has not taken that.
    pub(super) const fn awaits_blocks(&self) -> bool {
        match &self.kind {
            Kind::BlockUpload(upload) => !upload.is_open(),
            Kind::BlockDownload(download) => !download.is_open(),
            Kind::Upload(_) | Kind::Download(_) => false,
        }
    }

    /// Whether `bytes`, the answer that came last, may be another one of the same content.
    const fn may_repeat(&self, bytes: [u8; 8]) -> bool {
        match &self.kind {
            Kind::BlockUpload(upload) => upload.is_next(bytes),
            Kind::BlockDownload(_) => true,
            Kind::Upload(_) | Kind::Download(_) => false,
        }
    }

    /// Whether what comes next has no command but a sequence number.
    const fn is_in_block(&self) -> bool {
        matches!(&self.kind, Kind::BlockUpload(upload) if upload.is_in_block())
    }

    /// `80 ii ii ss` and the code. One for another address is late, and for a transfer that is over; one for none, 0000h, is
    /// taken: some servers do not know any more what they abort.
    fn on_abort(&self, bytes: [u8; 8]) -> Option<Step> {
        if self.is_in_block() && !BlockSegment::parse(bytes).is_abort() {
            return None;
        }
        let Response::Abort { address, code } = Response::parse(bytes) else {
            return None;
        };
        let is_ours = address == self.address || address == Address::new(0, 0);
        Some(if is_ours { Step::Refused(code) } else { Step::PassOver })
    }
}

fn open(job: &Job, opening: Opening) -> (Kind, Request) {
    match (&job.value, opening) {
        (None, Opening::Block) => kind(Kind::BlockUpload, BlockUpload::open(job.address)),
        (None, Opening::Adaptive) => kind(Kind::Upload, Upload::open(job.address, Some(BLOCKS_PAY))),
        (None, Opening::Plain) => kind(Kind::Upload, Upload::open(job.address, None)),
        (Some(value), Opening::Block) => kind(Kind::BlockDownload, BlockDownload::open(job.address, value.clone())),
        (Some(value), _) => kind(Kind::Download, Download::open(job.address, value.clone())),
    }
}

fn kind<T>(kind: fn(T) -> Kind, (transfer, request): (T, Request)) -> (Kind, Request) {
    (kind(transfer), request)
}

/// `80 ii ii ss` and the code, from the client.
pub(super) fn abort(address: Address, code: AbortCode) -> [u8; 8] {
    Request::Abort { address, code }.emit()
}
