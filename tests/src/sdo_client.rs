//! An SDO client that reads: expedited and segmented upload, one transfer at a time, and a whole device dumped by it.
//!
//! Sans-IO as the runtime: [`Upload`] is handed each frame and says what is to be sent. It believes nothing: a server that
//! answers for another object, forgets the toggle bit or sends another number of bytes than it announced is aborted, and the
//! abort code is the answer.

use lexican_eds::{
    dump::{AbortCode, Answer, Dump, Identity},
    ir,
};
use lexican_runtime::{
    self as runtime, Address, CanId, Device, Frame, NodeId,
    wire::sdo::{Request, Response, Segment},
};

use crate::bus::Bus;

/// How long the client waits for each answer, in ms.
pub const PATIENCE_MS: u64 = 500;

/// What is to be done after a frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// Send this and wait for the next frame.
    Send(Frame),
    /// Wait on: the frame was not for this client.
    Wait,
    /// The transfer is over.
    Done(Answer),
    /// The transfer is over, and the server is to be told so.
    Abort(Frame, Answer),
}

/// One transfer from the device to the client.
#[derive(Clone, Debug)]
pub struct Upload {
    node_id: NodeId,
    address: Address,
    state: State,
    bytes: Vec<u8>,
}

#[derive(Clone, Copy, Debug)]
enum State {
    /// `40 ii ii ss` was sent.
    Initiated,
    /// `60` or `70` was sent: `toggle` says which.
    Segments { toggle: bool, size: Option<u32> },
}

impl Upload {
    /// Asks `node_id` for `address`: the transfer and the frame to send.
    #[must_use]
    pub fn begin(node_id: NodeId, address: Address) -> (Self, Frame) {
        let state = State::Initiated;
        let upload = Self {
            node_id,
            address,
            state,
            bytes: Vec::new(),
        };
        let request = upload.request(Request::UploadInitiate { address });
        (upload, request)
    }

    /// Takes a frame from the bus.
    pub fn receive(&mut self, frame: &Frame) -> Step {
        let data = (frame.id() == CanId::sdo_response(self.node_id)).then(|| <[u8; 8]>::try_from(frame.data()).ok());
        let Some(data) = data.flatten() else {
            return Step::Wait;
        };
        match (self.state, Response::parse(data)) {
            (_, Response::Abort { code, .. }) => Step::Done(Answer::Abort(AbortCode(code.0))),
            (State::Initiated, response) => self.on_initiate(response),
            (State::Segments { toggle, size }, Response::UploadSegment(segment)) => {
                self.on_segment(toggle, size, segment)
            }
            (State::Segments { .. }, _) => self.abort(runtime::AbortCode::UNKNOWN_COMMAND),
        }
    }

    /// Gives up after [`PATIENCE_MS`] without an answer.
    #[must_use]
    pub fn time_out(&self) -> Step {
        let code = runtime::AbortCode::TIMED_OUT;
        Step::Abort(
            self.request(Request::Abort {
                address: self.address,
                code,
            }),
            Answer::Timeout,
        )
    }

    /// `43 ii ii ss dd dd dd dd`, or `41 ii ii ss` and the size in bytes.
    fn on_initiate(&mut self, response: Response) -> Step {
        match response {
            Response::UploadExpedited { address, value } if address == self.address => {
                let length = usize::from(value.length.unwrap_or(4));
                Step::Done(Answer::Value(value.bits.to_le_bytes()[..length].to_vec()))
            }
            Response::UploadInitiate { address, size } if address == self.address => self.ask_for_segment(false, size),
            _ => self.abort(runtime::AbortCode::UNKNOWN_COMMAND),
        }
    }

    /// `0t dd …`: up to seven bytes, the last segment marked.
    fn on_segment(&mut self, toggle: bool, size: Option<u32>, segment: Segment) -> Step {
        if segment.toggle != toggle {
            return self.abort(runtime::AbortCode::TOGGLE_NOT_ALTERNATED);
        }
        self.bytes.extend(segment.bytes());
        let announced = size.map(|size| usize::try_from(size).expect("an address space of 32 bits"));
        if announced.is_some_and(|size| self.bytes.len() > size) {
            return self.abort(runtime::AbortCode::TOO_LONG);
        }
        match announced {
            _ if !segment.last => self.ask_for_segment(!toggle, size),
            Some(size) if self.bytes.len() < size => self.abort(runtime::AbortCode::TOO_SHORT),
            _ => Step::Done(Answer::Value(std::mem::take(&mut self.bytes))),
        }
    }

    fn ask_for_segment(&mut self, toggle: bool, size: Option<u32>) -> Step {
        self.state = State::Segments { toggle, size };
        Step::Send(self.request(Request::UploadSegment { toggle }))
    }

    fn abort(&self, code: runtime::AbortCode) -> Step {
        let request = self.request(Request::Abort {
            address: self.address,
            code,
        });
        Step::Abort(request, Answer::Abort(AbortCode(code.0)))
    }

    fn request(&self, request: Request) -> Frame {
        Frame::full(CanId::sdo_request(self.node_id), request.emit())
    }
}

/// Reads one value over the bus.
///
/// # Panics
/// When the node has no node-ID.
pub fn upload<D: Device>(bus: &mut Bus<D>, address: Address) -> Answer {
    let (mut upload, request) = Upload::begin(bus.node().node_id().expect("a node-ID"), address);
    bus.put(request);
    loop {
        let step = match next_frame(bus) {
            Some(frame) => upload.receive(&frame),
            None => upload.time_out(),
        };
        match step {
            Step::Send(frame) => drop(bus.put(frame)),
            Step::Wait => {}
            Step::Done(answer) => return answer,
            Step::Abort(frame, answer) => {
                bus.put(frame);
                return answer;
            }
        }
    }
}

/// The next frame on the bus, waited for in time of the bus.
fn next_frame<D: Device>(bus: &mut Bus<D>) -> Option<Frame> {
    bus.take().or_else(|| bus.advance(PATIENCE_MS).take())
}

/// Reads all of `addresses`, as `lexican dump` would.
///
/// # Panics
/// When the node has no node-ID.
pub fn dump<D: Device>(bus: &mut Bus<D>, addresses: impl IntoIterator<Item = ir::Address>) -> Dump {
    let node_id = bus
        .node()
        .node_id()
        .and_then(|node_id| ir::NodeId::new(node_id.get()))
        .expect("a node-ID is a node-ID");
    let mut dump = Dump::new(node_id);
    dump.device = Some(identity(bus));
    for address in addresses {
        let answer = upload(bus, Address::new(address.index, address.sub));
        dump.objects.insert(address, answer);
    }
    dump
}

fn identity<D: Device>(bus: &mut Bus<D>) -> Identity {
    let mut number = |index, sub| {
        let answer = upload(bus, Address::new(index, sub));
        let bytes = answer.value()?.try_into().ok()?;
        Some(u32::from_le_bytes(bytes))
    };
    Identity {
        device_type: number(0x1000, 0),
        vendor_id: number(0x1018, 1),
        product_code: number(0x1018, 2),
        revision_number: number(0x1018, 3),
        serial_number: number(0x1018, 4),
    }
}
