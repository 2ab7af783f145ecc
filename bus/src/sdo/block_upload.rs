//! Block upload: up to 127 segments for each request, a CRC at the end.
//!
//! ```text
//! A4 08 10 00 7F 00 00 00 ─▶     ◀─ C6 08 10 00 0A 00 00 00     blocks of 127 segments, please; ten bytes, with a CRC
//! A3 00 00 00 00 00 00 00 ─▶     ◀─ 01 61 62 63 64 65 66 67     the first segment of the block
//!                                ◀─ 82 68 69 6A 00 00 00 00     bit 7: the last
//! A2 02 7F 00 00 00 00 00 ─▶     ◀─ D1 2A A3 00 00 00 00 00     four bytes of the last do not count; the CRC is A32Ah
//! A1 00 00 00 00 00 00 00 ─▶
//! ```

use lexican_runtime::{
    AbortCode, Address,
    sdo::crc,
    wire::sdo::{BlockSegment, Request, Response},
};

use super::{
    step::{Step, is_too_long, is_whole},
    upload::Upload,
};

/// Segments that a block may have: as many as there can be (CiA 301, 7.2.4.3.13).
const BLOCK_SIZE: u8 = 127;
/// How often one block is asked for again before the transfer is given up.
const REPEATS: u8 = 8;

/// Blocks are coming in.
#[derive(Clone, Debug)]
pub(super) struct BlockUpload {
    address: Address,
    state: State,
    /// What came in order.
    bytes: Vec<u8>,
    /// How often the present block was asked for again without a segment more.
    repeats: u8,
}

#[derive(Clone, Debug)]
enum State {
    Opened,
    /// The server took the plain protocol instead.
    Plain(Upload),
    Block(Block),
    End(Announced),
}

/// What the server said when it opened the transfer.
#[derive(Clone, Copy, Debug)]
struct Announced {
    crc: bool,
    size: Option<u32>,
}

#[derive(Clone, Copy, Debug)]
struct Block {
    announced: Announced,
    /// The number of the last segment that came behind all those before it; 0 for none.
    sequence: u8,
    /// Whether that segment is the value's last.
    complete: bool,
}

impl BlockUpload {
    /// `A4`: reads `address` in blocks.
    pub(super) fn open(address: Address) -> (Self, Request) {
        let upload = Self {
            address,
            state: State::Opened,
            bytes: Vec::new(),
            repeats: 0,
        };
        let request = Request::BlockUploadInitiate {
            address,
            crc: true,
            block_size: BLOCK_SIZE,
            threshold: 0,
        };
        (upload, request)
    }

    pub(super) fn receive(&mut self, bytes: [u8; 8]) -> Step {
        match &mut self.state {
            State::Opened => self.on_opened(Response::parse(bytes)),
            State::Plain(upload) => upload.receive(Response::parse(bytes)),
            State::Block(block) => {
                let block = *block;
                self.on_segment(block, BlockSegment::parse(bytes))
            }
            State::End(announced) => {
                let announced = *announced;
                self.on_end(announced, Response::parse(bytes))
            }
        }
    }

    /// Whether the server has taken the request.
    pub(super) const fn is_open(&self) -> bool {
        !matches!(self.state, State::Opened)
    }

    /// Whether what comes next is a segment, whose first byte is no command.
    pub(super) const fn is_in_block(&self) -> bool {
        matches!(self.state, State::Block(_))
    }

    /// Whether `bytes` are the segment behind the last one that came.
    pub(super) const fn is_next(&self, bytes: [u8; 8]) -> bool {
        match &self.state {
            State::Block(block) => BlockSegment::parse(bytes).sequence == block.sequence + 1,
            _ => false,
        }
    }

    pub(super) const fn awaited(&self) -> &'static str {
        match &self.state {
            State::Opened => "answer to the request for blocks",
            State::Plain(upload) => upload.awaited(),
            State::Block(_) => "segment of a block",
            State::End(_) => "end of the blocks",
        }
    }

    /// What is to be said when segments stay out: what came is acknowledged, so that the server sends the rest once more.
    ///
    /// `None` when nothing of the block came: then it may have been the acknowledgement that was lost, and the server would
    /// take a second one for that of another block.
    pub(super) fn on_silence(&mut self) -> Option<Step> {
        match self.state {
            State::Block(block) if block.sequence > 0 => Some(self.acknowledge(block)),
            _ => None,
        }
    }

    /// `C6 ii ii ss` and the size in bytes.
    fn on_opened(&mut self, response: Response) -> Step {
        match response {
            Response::BlockUploadInitiate { address, crc, size } if address == self.address => {
                self.begin_block(Announced { crc, size });
                Step::send(Request::BlockUploadStart)
            }
            Response::UploadExpedited { address, .. } | Response::UploadInitiate { address, .. }
                if address == self.address =>
            {
                let (mut upload, _) = Upload::open(address, None);
                let step = upload.receive(response);
                self.state = State::Plain(upload);
                step
            }
            Response::Unknown { address } if address == self.address => Step::Broken(AbortCode::UNKNOWN_COMMAND),
            _ => Step::PassOver,
        }
    }

    fn begin_block(&mut self, announced: Announced) {
        self.state = State::Block(Block {
            announced,
            sequence: 0,
            complete: false,
        });
    }

    /// `01` to `FF`: behind a gap nothing counts until the block is over.
    fn on_segment(&mut self, mut block: Block, segment: BlockSegment) -> Step {
        if segment.sequence == block.sequence + 1 && !block.complete {
            block.sequence = segment.sequence;
            block.complete = segment.last;
            self.bytes.extend(segment.data);
            self.state = State::Block(block);
            self.repeats = 0;
        }
        // The last segment has up to six bytes that do not count, and all seven when the value has none.
        if is_too_long(self.bytes.len().saturating_sub(7), block.announced.size) {
            return Step::Broken(AbortCode::TOO_LONG);
        }
        if segment.sequence == 0 {
            Step::Broken(AbortCode::INVALID_SEQUENCE_NUMBER)
        } else if segment.last || segment.sequence == BLOCK_SIZE {
            self.acknowledge(block)
        } else {
            Step::Wait
        }
    }

    /// `A2` and the last number that counts.
    fn acknowledge(&mut self, block: Block) -> Step {
        self.repeats += 1;
        if self.repeats > REPEATS {
            return Step::Broken(AbortCode::INVALID_SEQUENCE_NUMBER);
        }
        if block.complete {
            self.state = State::End(block.announced);
        } else {
            self.begin_block(block.announced);
        }
        Step::send(Request::BlockUploadAcknowledge {
            sequence: block.sequence,
            block_size: BLOCK_SIZE,
        })
    }

    /// `C1`, how many bytes of the last segment do not count, and the CRC.
    fn on_end(&mut self, announced: Announced, response: Response) -> Step {
        let Response::BlockUploadEnd { unused, crc: expected } = response else {
            return Step::Broken(AbortCode::UNKNOWN_COMMAND);
        };
        let length = self.bytes.len().saturating_sub(usize::from(unused));
        self.bytes.truncate(length);
        if !is_whole(length, announced.size) {
            return Step::Broken(match announced.size {
                Some(size) if is_too_long(length, Some(size)) => AbortCode::TOO_LONG,
                _ => AbortCode::TOO_SHORT,
            });
        }
        if announced.crc && crc(0, &self.bytes) != expected {
            return Step::Broken(AbortCode::CRC_ERROR);
        }
        Step::Last(Request::BlockUploadEnd.emit(), std::mem::take(&mut self.bytes))
    }
}
