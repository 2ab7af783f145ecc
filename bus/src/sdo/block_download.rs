//! Block download: as many segments at once as the server takes, a CRC at the end.
//!
//! ```text
//! C6 10 20 00 0A 00 00 00 ─▶     ◀─ A4 10 20 00 7F 00 00 00     ten bytes, with a CRC; blocks of 127 segments, please
//! 01 61 62 63 64 65 66 67 ─▶
//! 82 68 69 6A 00 00 00 00 ─▶     ◀─ A2 02 7F 00 00 00 00 00     both came
//! D1 2A A3 00 00 00 00 00 ─▶     ◀─ A1 00 00 00 00 00 00 00     written
//! ```

use lexican_runtime::{
    AbortCode, Address,
    sdo::crc,
    wire::sdo::{BlockSegment, Request, Response},
};

use super::step::Step;

/// How often one block is sent again before the transfer is given up.
const REPEATS: u8 = 8;

/// Blocks are going out.
#[derive(Clone, Debug)]
pub(super) struct BlockDownload {
    address: Address,
    state: State,
    bytes: Vec<u8>,
    /// Whether the server checks the CRC.
    crc: bool,
    /// How often a block was sent without a segment more being taken.
    repeats: u8,
}

#[derive(Clone, Copy, Debug)]
enum State {
    Opened,
    /// `sent` segments from byte `start` on were sent.
    Block {
        start: usize,
        sent: u8,
    },
    End,
}

impl BlockDownload {
    /// `C6`: writes `bytes` to `address` in blocks.
    pub(super) fn open(address: Address, bytes: Vec<u8>) -> (Self, Request) {
        let request = Request::BlockDownloadInitiate {
            address,
            crc: true,
            size: u32::try_from(bytes.len()).ok(),
        };
        let download = Self {
            address,
            state: State::Opened,
            bytes,
            crc: false,
            repeats: 0,
        };
        (download, request)
    }

    pub(super) fn receive(&mut self, response: Response) -> Step {
        match (self.state, response) {
            (State::Opened, response) => self.on_opened(response),
            (State::Block { start, sent }, Response::BlockDownloadAcknowledge { sequence, block_size }) => {
                self.on_acknowledge(start, sent, sequence, block_size)
            }
            (State::End, Response::BlockDownloadEnd) => Step::Done(Vec::new()),
            _ => Step::Broken(AbortCode::UNKNOWN_COMMAND),
        }
    }

    /// Whether the server has taken the request.
    pub(super) const fn is_open(&self) -> bool {
        !matches!(self.state, State::Opened)
    }

    pub(super) const fn awaited(&self) -> &'static str {
        match self.state {
            State::Opened => "answer to the request for blocks",
            State::Block { .. } => "acknowledgement of a block",
            State::End => "confirmation of the value",
        }
    }

    /// `A4 ii ii ss` and the number of segments that may come.
    fn on_opened(&mut self, response: Response) -> Step {
        match response {
            Response::BlockDownloadInitiate {
                address,
                crc,
                block_size,
            } if address == self.address => {
                self.crc = crc;
                self.send_block(0, block_size)
            }
            Response::Unknown { address } | Response::DownloadInitiate { address } if address == self.address => {
                Step::Broken(AbortCode::UNKNOWN_COMMAND)
            }
            _ => Step::PassOver,
        }
    }

    /// `A2`, the last number that came, and how many segments may come next.
    fn on_acknowledge(&mut self, start: usize, sent: u8, sequence: u8, block_size: u8) -> Step {
        if sequence > sent {
            return Step::Broken(AbortCode::INVALID_SEQUENCE_NUMBER);
        }
        self.repeats = if sequence == 0 { self.repeats + 1 } else { 0 };
        if self.repeats > REPEATS {
            return Step::Broken(AbortCode::INVALID_SEQUENCE_NUMBER);
        }
        let taken = start + 7 * usize::from(sequence);
        if taken >= self.bytes.len() && sequence > 0 {
            return self.send_end();
        }
        self.send_block(taken, block_size)
    }

    /// Up to `block_size` segments from byte `start` on.
    fn send_block(&mut self, start: usize, block_size: u8) -> Step {
        if !(1..=127).contains(&block_size) {
            return Step::Broken(AbortCode::INVALID_BLOCK_SIZE);
        }
        let rest = self.bytes.get(start..).unwrap_or_default();
        // Of no bytes one empty segment is sent: there has to be a last one.
        let all = rest.len().div_ceil(7).max(1);
        let segments: Vec<_> = (1..=block_size)
            .zip(0..all)
            .map(|(sequence, at)| segment(sequence, at + 1 == all, rest.get(7 * at..).unwrap_or_default()))
            .collect();
        let sent = u8::try_from(segments.len()).unwrap_or(block_size);
        self.state = State::Block { start, sent };
        Step::Send(segments)
    }

    /// `C1`, how many bytes of the last segment do not count, and the CRC.
    fn send_end(&mut self) -> Step {
        self.state = State::End;
        let unused = (7 - self.bytes.len() % 7) % 7;
        Step::send(Request::BlockDownloadEnd {
            unused: if self.bytes.is_empty() {
                7
            } else {
                u8::try_from(unused).unwrap_or(0)
            },
            crc: if self.crc { crc(0, &self.bytes) } else { 0 },
        })
    }
}

/// Up to seven of `bytes`.
fn segment(sequence: u8, last: bool, bytes: &[u8]) -> [u8; 8] {
    let mut data = [0; 7];
    for (place, byte) in data.iter_mut().zip(bytes) {
        *place = *byte;
    }
    BlockSegment { last, sequence, data }.emit()
}
