//! An SDO client on a [`Bus`]: reads and writes whole values.

use lexican_runtime::{
    AbortCode, Address, CanId, Device, Frame,
    sdo::crc,
    wire::sdo::{BlockSegment, Expedited, Request, Response, Segment},
};

use crate::bus::Bus;

/// How a value is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Manner {
    /// In the request itself; for one to four bytes.
    Expedited,
    /// In segments of at most so many bytes, 1 to 7.
    Segmented {
        /// Bytes in a segment.
        step: usize,
        /// Whether the size is announced.
        announced: bool,
    },
    /// In blocks with a CRC.
    Block {
        /// Whether the size is announced.
        announced: bool,
        /// The segment that gets lost once, counted from 0; the last of a block does not.
        lost: usize,
    },
}

/// Reads the value at `address`.
///
/// # Errors
/// The server's abort code.
///
/// # Panics
/// When the server does not keep to the protocol.
pub fn upload<D: Device>(bus: &mut Bus<D>, address: Address) -> Result<Vec<u8>, AbortCode> {
    let size = match ask(bus, Request::UploadInitiate { address })? {
        Response::UploadExpedited { address: echo, value } => {
            assert_eq!(echo, address);
            return Ok(bytes(value));
        }
        Response::UploadInitiate { address: echo, size } => {
            assert_eq!(echo, address);
            size.expect("this server says how much there is")
        }
        other => panic!("{other:?} in answer to an upload"),
    };
    let mut value = Vec::new();
    for toggle in [false, true].into_iter().cycle() {
        let Response::UploadSegment(segment) = ask(bus, Request::UploadSegment { toggle })? else {
            panic!("no segment in answer to {toggle}");
        };
        assert_eq!(segment.toggle, toggle);
        value.extend(segment.bytes());
        if segment.last {
            break;
        }
    }
    assert_eq!(
        value.len(),
        usize::try_from(size).expect("a size"),
        "as many bytes as were announced"
    );
    Ok(value)
}

/// Writes `value` to `address`.
///
/// # Errors
/// The server's abort code.
///
/// # Panics
/// When the server does not keep to the protocol, or the value is too long for the manner.
pub fn download<D: Device>(bus: &mut Bus<D>, address: Address, value: &[u8], manner: Manner) -> Result<(), AbortCode> {
    let (step, announced) = match manner {
        Manner::Expedited => {
            let value = expedited(value);
            let response = ask(bus, Request::DownloadExpedited { address, value })?;
            assert_eq!(response, Response::DownloadInitiate { address });
            return Ok(());
        }
        Manner::Segmented { step, announced } => (step, announced),
        Manner::Block { announced, lost } => return download_blocks(bus, address, value, announced, lost),
    };
    let size = announced.then(|| u32::try_from(value.len()).expect("a size"));
    let response = ask(bus, Request::DownloadInitiate { address, size })?;
    assert_eq!(response, Response::DownloadInitiate { address });
    for (number, part) in segments(value, step).into_iter().enumerate() {
        let last = (number + 1) * step >= value.len();
        let segment = segment(part, number % 2 == 1, last);
        let response = ask(bus, Request::DownloadSegment(segment))?;
        assert_eq!(response, Response::DownloadSegment { toggle: segment.toggle });
    }
    Ok(())
}

fn download_blocks<D: Device>(
    bus: &mut Bus<D>,
    address: Address,
    value: &[u8],
    announced: bool,
    mut lost: usize,
) -> Result<(), AbortCode> {
    let size = announced.then(|| u32::try_from(value.len()).expect("a size"));
    let initiate = Request::BlockDownloadInitiate {
        address,
        crc: true,
        size,
    };
    let Response::BlockDownloadInitiate { block_size, .. } = ask(bus, initiate)? else {
        panic!("no blocks may be sent");
    };
    let parts = segments(value, 7);
    let mut taken = 0;
    while taken < parts.len() {
        let end = parts.len().min(taken + usize::from(block_size));
        let mut answer = None;
        for at in taken..end {
            if at == lost && at + 1 < end {
                lost = usize::MAX;
                continue;
            }
            let segment = BlockSegment {
                last: at + 1 == parts.len(),
                sequence: u8::try_from(at - taken + 1).expect("a sequence number"),
                data: segment(parts[at], false, false).data,
            };
            send(bus, segment.emit());
            answer = answer.or(response(bus)?);
        }
        let Some(Response::BlockDownloadAcknowledge { sequence, .. }) = answer else {
            panic!("{answer:?} after a block");
        };
        taken += usize::from(sequence);
    }
    let unused = u8::try_from(parts.len() * 7 - value.len()).expect("up to seven");
    let crc = crc(0, value);
    let end = ask(bus, Request::BlockDownloadEnd { unused, crc })?;
    assert_eq!(end, Response::BlockDownloadEnd);
    Ok(())
}

/// Reads the value at `address` in blocks of `block_size` segments with a CRC; the segment `lost`, counted from 0, and all
/// behind it in its block get lost once.
///
/// # Errors
/// The server's abort code.
///
/// # Panics
/// When the server does not keep to the protocol.
pub fn upload_blocks<D: Device>(
    bus: &mut Bus<D>,
    address: Address,
    block_size: u8,
    mut lost: usize,
) -> Result<Vec<u8>, AbortCode> {
    let initiate = Request::BlockUploadInitiate {
        address,
        crc: true,
        block_size,
        threshold: 0,
    };
    let Response::BlockUploadInitiate {
        crc: true,
        size: Some(size),
        ..
    } = ask(bus, initiate)?
    else {
        panic!("no blocks will come");
    };
    let (mut parts, mut is_last) = (Vec::new(), false);
    let mut request = Request::BlockUploadStart;
    while !is_last {
        send(bus, request.emit());
        let before = parts.len();
        for frame in std::iter::from_fn(|| bus.take()).collect::<Vec<_>>() {
            if parts.len() == lost {
                lost = usize::MAX;
                break;
            }
            let segment = BlockSegment::parse(frame.full_data().expect("eight bytes"));
            assert_eq!(usize::from(segment.sequence), parts.len() - before + 1);
            parts.push(segment.data);
            is_last = segment.last;
        }
        let sequence = u8::try_from(parts.len() - before).expect("up to 127");
        request = Request::BlockUploadAcknowledge { sequence, block_size };
    }
    let Response::BlockUploadEnd { unused, crc: sum } = ask(bus, request)? else {
        panic!("no end");
    };
    let mut value = parts.concat();
    value.truncate(value.len() - usize::from(unused));
    assert_eq!(
        (value.len(), sum),
        (usize::try_from(size).expect("a size"), crc(0, &value))
    );
    send(bus, Request::BlockUploadEnd.emit());
    bus.silence();
    Ok(value)
}

/// `value` in parts; one empty part of an empty value.
fn segments(value: &[u8], step: usize) -> Vec<&[u8]> {
    if value.is_empty() {
        vec![value]
    } else {
        value.chunks(step).collect()
    }
}

fn segment(part: &[u8], toggle: bool, last: bool) -> Segment {
    let mut data = [0xA5; 7];
    data[..part.len()].copy_from_slice(part);
    Segment {
        toggle,
        last,
        length: u8::try_from(part.len()).expect("seven bytes"),
        data,
    }
}

fn expedited(value: &[u8]) -> Expedited {
    let mut word = [0; 4];
    word[..value.len()].copy_from_slice(value);
    Expedited {
        bits: u32::from_le_bytes(word),
        length: Some(u8::try_from(value.len()).expect("four bytes")),
    }
}

fn bytes(value: Expedited) -> Vec<u8> {
    let length = value.length.expect("this server says how much there is");
    value.bits.to_le_bytes()[..usize::from(length)].to_vec()
}

/// Sends a request and takes the one response to it.
fn ask<D: Device>(bus: &mut Bus<D>, request: Request) -> Result<Response, AbortCode> {
    send(bus, request.emit());
    Ok(response(bus)?.unwrap_or_else(|| panic!("no answer to {request:?}")))
}

/// The response that has come, if one has.
fn response<D: Device>(bus: &mut Bus<D>) -> Result<Option<Response>, AbortCode> {
    let Some(frame) = bus.take() else { return Ok(None) };
    let node_id = bus.node().node_id().expect("a node-ID");
    assert_eq!(frame.id(), CanId::sdo_response(node_id));
    match Response::parse(frame.full_data().expect("eight bytes")) {
        Response::Abort { code, .. } => Err(code),
        response => Ok(Some(response)),
    }
}

fn send<D: Device>(bus: &mut Bus<D>, request: [u8; 8]) {
    let node_id = bus.node().node_id().expect("a node-ID");
    bus.put(Frame::full(CanId::sdo_request(node_id), request));
}
