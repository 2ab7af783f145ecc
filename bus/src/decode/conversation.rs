//! An SDO channel, overheard: what client and server say to each other becomes the values that they exchange.

use lexican_runtime::{
    AbortCode, Address, sdo,
    wire::sdo::{BlockSegment, Request, Response},
};

use super::block::Block;

/// A value longer than that is not gathered: no object is, and a damaged log shall not fill the memory.
const LONGEST_VALUE: usize = 16 << 20;

/// What the client does with the object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// Upload.
    Read,
    /// Download.
    Write,
}

/// How a transfer ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The whole value went over; [`Conversation::value`] has it. Whether its length was said.
    Value {
        /// `false` for four bytes of which the sender did not say how many count.
        sized: bool,
    },
    /// One side gave up.
    Abort(AbortCode),
    /// The client asked for something else before there was an answer.
    Unanswered,
    /// It came to its end, and frames of it are missing in what was overheard.
    Incomplete,
}

/// A transfer that has come to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ended {
    /// Reading or writing.
    pub access: Access,
    /// What.
    pub address: Address,
    /// How it ended.
    pub outcome: Outcome,
}

/// What a frame says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Said {
    /// The client.
    Request(Request),
    /// The server.
    Response(Response),
    /// A part of a block, from the side that has the value.
    Segment(BlockSegment),
}

/// What a frame does in the conversation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// What it says.
    pub said: Said,
    /// The object that it is about; `None` where neither the frame nor what was overheard before tells.
    pub address: Option<Address>,
    /// The transfer that this frame shows to be over without an answer.
    pub before: Option<Ended>,
    /// The transfer that this frame ends.
    pub ended: Option<Ended>,
}

/// One SDO channel.
#[derive(Clone, Debug, Default)]
pub struct Conversation {
    transfer: Option<Transfer>,
    value: Vec<u8>,
}

#[derive(Clone, Debug)]
struct Transfer {
    access: Access,
    address: Address,
    phase: Phase,
    /// As one side announced it.
    size: Option<u32>,
    sized: bool,
    toggle: bool,
    /// Something of it was not overheard.
    has_hole: bool,
    /// Both sides know the CRC.
    has_crc: bool,
    block: Block,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    /// The first request was heard.
    Asked,
    Segments,
    Blocks,
    /// The last block was taken.
    LastBlock,
    /// All is said, and the server has to confirm it.
    Confirmation,
}

impl Conversation {
    /// The value of the transfer that ended last.
    #[must_use]
    pub fn value(&self) -> &[u8] {
        &self.value
    }

    /// The object of the transfer that goes on.
    #[must_use]
    pub fn address(&self) -> Option<Address> {
        self.transfer.as_ref().map(|transfer| transfer.address)
    }

    /// Takes a frame of the client.
    pub fn request(&mut self, bytes: [u8; 8]) -> Step {
        let segment = BlockSegment::parse(bytes);
        if self.is_in_blocks(Access::Write) && !segment.is_abort() {
            return self.segment(segment);
        }
        let request = Request::parse(bytes);
        let before = self.begin(request);
        let address = self.address();
        let ended = self.heard_request(request);
        Step {
            said: Said::Request(request),
            address,
            before,
            ended,
        }
    }

    /// Takes a frame of the server.
    pub fn response(&mut self, bytes: [u8; 8]) -> Step {
        let segment = BlockSegment::parse(bytes);
        if self.is_in_blocks(Access::Read) && !segment.is_abort() {
            return self.segment(segment);
        }
        let response = Response::parse(bytes);
        let address = self.address().or_else(|| named(response));
        Step {
            said: Said::Response(response),
            address,
            before: None,
            ended: self.heard_response(response),
        }
    }

    fn is_in_blocks(&self, access: Access) -> bool {
        let transfer = self.transfer.as_ref();
        transfer.is_some_and(|transfer| transfer.access == access && transfer.phase == Phase::Blocks)
    }

    fn segment(&mut self, segment: BlockSegment) -> Step {
        if let Some(transfer) = &mut self.transfer {
            transfer.block.take(segment);
        }
        Step {
            said: Said::Segment(segment),
            address: self.address(),
            before: None,
            ended: None,
        }
    }

    /// Opens a transfer when `request` does so; gives the one that it leaves behind without an answer.
    fn begin(&mut self, request: Request) -> Option<Ended> {
        let (access, address, size) = match request {
            Request::UploadInitiate { address } | Request::BlockUploadInitiate { address, .. } => {
                (Access::Read, address, None)
            }
            Request::DownloadExpedited { address, .. } => (Access::Write, address, None),
            Request::DownloadInitiate { address, size } | Request::BlockDownloadInitiate { address, size, .. } => {
                (Access::Write, address, size)
            }
            _ => return None,
        };
        self.value.clear();
        let left = self.transfer.replace(Transfer::new(access, address, size))?;
        let is_unanswered = matches!(left.phase, Phase::Asked | Phase::Confirmation) && left.address != address;
        is_unanswered.then_some(left.ended(Outcome::Unanswered))
    }

    fn heard_request(&mut self, request: Request) -> Option<Ended> {
        let transfer = self.transfer.as_mut()?;
        match request {
            Request::DownloadExpedited { value, .. } => {
                let length = value.length.unwrap_or(4);
                self.value
                    .extend(value.bits.to_le_bytes().iter().take(usize::from(length)));
                transfer.sized = value.length.is_some();
                transfer.phase = Phase::Confirmation;
            }
            Request::DownloadSegment(segment) if transfer.is_at(Access::Write, Phase::Segments) => {
                transfer.alternate(segment.toggle);
                append(&mut self.value, segment.bytes(), transfer);
                if segment.last {
                    transfer.phase = Phase::Confirmation;
                }
            }
            Request::BlockDownloadInitiate { crc, .. } | Request::BlockUploadInitiate { crc, .. } => {
                transfer.has_crc = crc;
            }
            Request::BlockUploadStart => transfer.phase = Phase::Blocks,
            Request::BlockUploadAcknowledge { sequence, .. } => self.acknowledge(sequence),
            Request::BlockDownloadEnd { unused, crc } if transfer.phase == Phase::LastBlock => {
                transfer.phase = Phase::Confirmation;
                self.cut(unused, crc);
            }
            Request::Abort { code, .. } => return self.end(Outcome::Abort(code)),
            _ => {}
        }
        None
    }

    fn heard_response(&mut self, response: Response) -> Option<Ended> {
        let transfer = self.transfer.as_mut()?;
        match response {
            Response::UploadExpedited { address, value } if transfer.asks(Access::Read, address) => {
                let length = value.length.unwrap_or(4);
                self.value
                    .extend(value.bits.to_le_bytes().iter().take(usize::from(length)));
                transfer.sized = value.length.is_some();
                return self.end_with_value();
            }
            Response::UploadInitiate { address, size } if transfer.asks(Access::Read, address) => {
                transfer.size = size;
                transfer.phase = Phase::Segments;
            }
            Response::UploadSegment(segment) if transfer.is_at(Access::Read, Phase::Segments) => {
                transfer.alternate(segment.toggle);
                append(&mut self.value, segment.bytes(), transfer);
                if segment.last {
                    return self.end_with_value();
                }
            }
            Response::DownloadInitiate { address } if transfer.asks(Access::Write, address) => {
                transfer.phase = Phase::Segments;
            }
            Response::BlockDownloadInitiate { address, crc, .. } if transfer.asks(Access::Write, address) => {
                transfer.has_crc &= crc;
                transfer.phase = Phase::Blocks;
            }
            Response::BlockUploadInitiate { address, crc, size } if transfer.asks(Access::Read, address) => {
                transfer.has_crc &= crc;
                transfer.size = size;
            }
            Response::BlockDownloadAcknowledge { sequence, .. } => self.acknowledge(sequence),
            Response::BlockUploadEnd { unused, crc } if transfer.is_at(Access::Read, Phase::LastBlock) => {
                self.cut(unused, crc);
                return self.end_with_value();
            }
            Response::DownloadInitiate { .. } | Response::DownloadSegment { .. } | Response::BlockDownloadEnd
                if transfer.is_at(Access::Write, Phase::Confirmation) =>
            {
                return self.end_with_value();
            }
            Response::Abort { code, .. } => return self.end(Outcome::Abort(code)),
            _ => {}
        }
        None
    }

    /// The receiver has taken the first `sequence` segments of the block.
    fn acknowledge(&mut self, sequence: u8) {
        let Some(transfer) = self
            .transfer
            .as_mut()
            .filter(|transfer| transfer.phase == Phase::Blocks)
        else {
            return;
        };
        let (is_last, is_whole) = (transfer.block.is_last(sequence), transfer.block.has(sequence));
        transfer.has_hole |= !is_whole;
        let block = transfer.block.first(sequence);
        if self.value.len() + block.len() <= LONGEST_VALUE {
            self.value.extend_from_slice(block);
        } else {
            transfer.has_hole = true;
        }
        transfer.block.clear();
        if is_last {
            transfer.phase = Phase::LastBlock;
        }
    }

    /// Takes off the bytes of the last segment that do not count, and looks at the CRC.
    fn cut(&mut self, unused: u8, crc: u16) {
        let length = self.value.len().saturating_sub(usize::from(unused));
        self.value.truncate(length);
        if let Some(transfer) = &mut self.transfer {
            transfer.has_hole |= transfer.has_crc && sdo::crc(0, &self.value) != crc;
        }
    }

    fn end_with_value(&mut self) -> Option<Ended> {
        let transfer = self.transfer.as_ref()?;
        let length = u32::try_from(self.value.len()).ok();
        let is_whole = !transfer.has_hole && (transfer.size.is_none() || transfer.size == length);
        let outcome = if is_whole {
            Outcome::Value { sized: transfer.sized }
        } else {
            Outcome::Incomplete
        };
        self.end(outcome)
    }

    fn end(&mut self, outcome: Outcome) -> Option<Ended> {
        self.transfer.take().map(|transfer| transfer.ended(outcome))
    }
}

impl Transfer {
    const fn new(access: Access, address: Address, size: Option<u32>) -> Self {
        Self {
            access,
            address,
            phase: Phase::Asked,
            size,
            sized: true,
            toggle: false,
            has_hole: false,
            has_crc: false,
            block: Block::EMPTY,
        }
    }

    const fn ended(&self, outcome: Outcome) -> Ended {
        Ended {
            access: self.access,
            address: self.address,
            outcome,
        }
    }

    fn is_at(&self, access: Access, phase: Phase) -> bool {
        self.access == access && self.phase == phase
    }

    fn asks(&self, access: Access, address: Address) -> bool {
        self.is_at(access, Phase::Asked) && self.address == address
    }

    /// A segment with the wrong toggle bit is not the one that follows.
    fn alternate(&mut self, toggle: bool) {
        self.has_hole |= self.toggle != toggle;
        self.toggle = !toggle;
    }
}

fn append(value: &mut Vec<u8>, bytes: &[u8], transfer: &mut Transfer) {
    if value.len() < LONGEST_VALUE {
        value.extend_from_slice(bytes);
    } else {
        transfer.has_hole = true;
    }
}

/// The object that a response names itself.
const fn named(response: Response) -> Option<Address> {
    match response {
        Response::UploadExpedited { address, .. }
        | Response::UploadInitiate { address, .. }
        | Response::DownloadInitiate { address }
        | Response::Abort { address, .. }
        | Response::BlockDownloadInitiate { address, .. }
        | Response::BlockUploadInitiate { address, .. } => Some(address),
        _ => None,
    }
}
