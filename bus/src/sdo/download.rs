//! Download: the value in the request itself, or in segments of seven bytes.
//!
//! ```text
//! 2B 17 10 00 F4 01 00 00 ─▶     ◀─ 60 17 10 00 00 00 00 00     two bytes, written
//!
//! 21 10 20 00 0A 00 00 00 ─▶     ◀─ 60 10 20 00 00 00 00 00     ten bytes will come
//! 00 61 62 63 64 65 66 67 ─▶     ◀─ 20 00 00 00 00 00 00 00
//! 19 68 69 6A 00 00 00 00 ─▶     ◀─ 30 00 00 00 00 00 00 00     bit 0: the last; written
//! ```

use lexican_runtime::{
    AbortCode, Address,
    wire::sdo::{Expedited, Request, Response, Segment},
};

use super::step::Step;

/// A value is going out.
#[derive(Clone, Debug)]
pub(super) struct Download {
    address: Address,
    state: State,
    bytes: Vec<u8>,
}

#[derive(Clone, Copy, Debug)]
enum State {
    /// The value stood in the request.
    Opened,
    /// The size stood in the request.
    Announced,
    /// A segment that ends at `end` was sent.
    Segments { toggle: bool, end: usize },
}

impl Download {
    /// `2x`: writes `bytes` to `address`.
    pub(super) fn open(address: Address, bytes: Vec<u8>) -> (Self, Request) {
        let (state, request) = match u8::try_from(bytes.len()) {
            Ok(length @ 1..=4) => (State::Opened, expedited(address, length, &bytes)),
            _ => (State::Announced, announcement(address, bytes.len())),
        };
        (Self { address, state, bytes }, request)
    }

    pub(super) fn receive(&mut self, response: Response) -> Step {
        match (self.state, response) {
            (State::Segments { toggle, end }, Response::DownloadSegment { toggle: taken }) => {
                self.on_segment(toggle, end, taken)
            }
            (State::Segments { .. }, _) => Step::Broken(AbortCode::UNKNOWN_COMMAND),
            (_, response) => self.on_opened(response),
        }
    }

    pub(super) const fn awaited(&self) -> &'static str {
        match self.state {
            State::Opened | State::Announced => "answer to the request",
            State::Segments { .. } => "confirmation of a segment",
        }
    }

    /// `60 ii ii ss`
    fn on_opened(&mut self, response: Response) -> Step {
        match response {
            Response::DownloadInitiate { address } if address == self.address => match self.state {
                State::Announced => self.send(false, 0),
                _ => Step::Done(Vec::new()),
            },
            Response::Unknown { address }
            | Response::UploadInitiate { address, .. }
            | Response::UploadExpedited { address, .. }
                if address == self.address =>
            {
                Step::Broken(AbortCode::UNKNOWN_COMMAND)
            }
            _ => Step::PassOver,
        }
    }

    /// `20` or `30`
    fn on_segment(&mut self, toggle: bool, end: usize, taken: bool) -> Step {
        if taken != toggle {
            return Step::Broken(AbortCode::TOGGLE_NOT_ALTERNATED);
        }
        if end == self.bytes.len() {
            return Step::Done(Vec::new());
        }
        self.send(!toggle, end)
    }

    /// The segment that begins at `start`.
    fn send(&mut self, toggle: bool, start: usize) -> Step {
        let end = self.bytes.len().min(start + 7);
        let bytes = self.bytes.get(start..end).unwrap_or_default();
        let mut data = [0; 7];
        for (place, byte) in data.iter_mut().zip(bytes) {
            *place = *byte;
        }
        self.state = State::Segments { toggle, end };
        Step::send(Request::DownloadSegment(Segment {
            toggle,
            last: end == self.bytes.len(),
            length: u8::try_from(bytes.len()).unwrap_or(7),
            data,
        }))
    }
}

fn expedited(address: Address, length: u8, bytes: &[u8]) -> Request {
    let bits = bytes.iter().rfold(0, |bits, byte| bits << 8 | u32::from(*byte));
    let length = Some(length);
    Request::DownloadExpedited {
        address,
        value: Expedited { bits, length },
    }
}

fn announcement(address: Address, length: usize) -> Request {
    let size = u32::try_from(length).ok();
    Request::DownloadInitiate { address, size }
}
