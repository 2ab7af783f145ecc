//! Upload: the value in the answer itself, or in segments of seven bytes.
//!
//! ```text
//! 40 08 10 00 00 00 00 00 ─▶     ◀─ 43 08 10 00 57 44 47 41     "WDGA" at once
//!
//! 40 08 10 00 00 00 00 00 ─▶     ◀─ 41 08 10 00 0A 00 00 00     ten bytes will come
//! 60 00 00 00 00 00 00 00 ─▶     ◀─ 00 61 62 63 64 65 66 67
//! 70 00 00 00 00 00 00 00 ─▶     ◀─ 19 68 69 6A 00 00 00 00     bit 0: the last
//! ```

use lexican_runtime::{
    AbortCode, Address,
    wire::sdo::{Request, Response, Segment},
};

use super::step::{Step, expedited, is_too_long, is_whole};

/// A value is coming in.
#[derive(Clone, Debug)]
pub(super) struct Upload {
    address: Address,
    /// From how many bytes on blocks are to be tried; `None` for never.
    blocks_from: Option<u32>,
    state: State,
    bytes: Vec<u8>,
}

#[derive(Clone, Copy, Debug)]
enum State {
    Opened,
    Segments { toggle: bool, size: Option<u32> },
}

impl Upload {
    /// `40`: reads `address`.
    pub(super) fn open(address: Address, blocks_from: Option<u32>) -> (Self, Request) {
        let upload = Self {
            address,
            blocks_from,
            state: State::Opened,
            bytes: Vec::new(),
        };
        (upload, Request::UploadInitiate { address })
    }

    pub(super) fn receive(&mut self, response: Response) -> Step {
        match (self.state, response) {
            (State::Opened, response) => self.on_opened(response),
            (State::Segments { toggle, size }, Response::UploadSegment(segment)) => {
                self.on_segment(toggle, size, segment)
            }
            (State::Segments { .. }, _) => Step::Broken(AbortCode::UNKNOWN_COMMAND),
        }
    }

    pub(super) const fn awaited(&self) -> &'static str {
        match self.state {
            State::Opened => "answer to the request",
            State::Segments { .. } => "segment of the value",
        }
    }

    /// `43 ii ii ss dd dd dd dd`, or `41 ii ii ss` and the size in bytes.
    fn on_opened(&mut self, response: Response) -> Step {
        match response {
            Response::UploadExpedited { address, value } if address == self.address => Step::Done(expedited(value)),
            Response::UploadInitiate { address, size } if address == self.address => self.on_size(size),
            Response::Unknown { address } | Response::DownloadInitiate { address } if address == self.address => {
                Step::Broken(AbortCode::UNKNOWN_COMMAND)
            }
            _ => Step::PassOver,
        }
    }

    fn on_size(&mut self, size: Option<u32>) -> Step {
        let pays = |least| size.is_none_or(|size| size >= least);
        if self.blocks_from.is_some_and(pays) {
            return Step::ToBlocks;
        }
        self.ask(false, size)
    }

    /// `0t dd …`: up to seven bytes, the last segment marked.
    fn on_segment(&mut self, toggle: bool, size: Option<u32>, segment: Segment) -> Step {
        if segment.toggle != toggle {
            return Step::Broken(AbortCode::TOGGLE_NOT_ALTERNATED);
        }
        self.bytes.extend(segment.bytes());
        if is_too_long(self.bytes.len(), size) {
            return Step::Broken(AbortCode::TOO_LONG);
        }
        if !segment.last {
            return self.ask(!toggle, size);
        }
        if !is_whole(self.bytes.len(), size) {
            return Step::Broken(AbortCode::TOO_SHORT);
        }
        Step::Done(std::mem::take(&mut self.bytes))
    }

    fn ask(&mut self, toggle: bool, size: Option<u32>) -> Step {
        self.state = State::Segments { toggle, size };
        Step::send(Request::UploadSegment { toggle })
    }
}
