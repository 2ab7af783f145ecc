//! python-can's CSV: `timestamp,arbitration_id,extended,remote,error,dlc,data`, the data in Base64.

use data_encoding::BASE64;
use lexican_runtime::wire::{CanId, Frame};

use super::{
    line::{Line, NO_DATA, NO_IDENTIFIER, NO_TIME, OTHER_LENGTH},
    number::{decimal, hexadecimal, micros},
};

const HEADER: &[u8] = b"timestamp,arbitration_id,extended,remote,error,dlc,data";

/// What the buses of this format are called: it has one.
const CHANNEL: &[u8] = b"can0";

/// Reads a line.
pub(super) fn parse(line: &[u8]) -> Line<'_> {
    if is_beginning(line) || line.is_empty() {
        return Line::Other;
    }
    let mut columns = line.split(|&byte| byte == b',');
    let mut column = || columns.next().map(<[u8]>::trim_ascii);
    let [
        Some(time),
        Some(id),
        Some(extended),
        Some(remote),
        Some(error),
        Some(length),
        Some(data),
        None,
    ] = std::array::from_fn(|_| column())
    else {
        return Line::Damaged("there are not seven columns");
    };
    let Some(time) = micros(time) else {
        return Line::Damaged(NO_TIME);
    };
    if error == b"1" {
        return Line::Other;
    }
    let Some(id) = identifier(id, extended) else {
        return Line::Damaged(NO_IDENTIFIER);
    };
    match frame(id, remote, length, data) {
        Ok(Some(frame)) => Line::Frame {
            time,
            channel: CHANNEL,
            frame,
        },
        Ok(None) => Line::Other,
        Err(reason) => Line::Damaged(reason),
    }
}

/// Whether `line` is the header.
pub(super) fn is_beginning(line: &[u8]) -> bool {
    line == HEADER
}

fn identifier(id: &[u8], extended: &[u8]) -> Option<CanId> {
    let number = hexadecimal(id.strip_prefix(b"0x")?)?;
    match extended {
        b"1" => CanId::extended(number),
        b"0" => CanId::standard(number),
        _ => None,
    }
}

/// `None` for a frame that is too long for classic CAN.
fn frame(id: CanId, remote: &[u8], length: &[u8], data: &[u8]) -> Result<Option<Frame>, &'static str> {
    let length = decimal(length).ok_or(OTHER_LENGTH)?;
    let Some(length) = u8::try_from(length).ok().filter(|&length| length <= 8) else {
        return Ok(None);
    };
    if remote == b"1" {
        return Ok(Frame::remote(id, length));
    }
    // Twelve characters are nine bytes at most.
    let mut bytes = [0; 9];
    let room = bytes.get_mut(..data.len() / 4 * 3).ok_or(NO_DATA)?;
    let count = BASE64.decode_mut(data, room).map_err(|_| NO_DATA)?;
    if count != usize::from(length) {
        return Err(OTHER_LENGTH);
    }
    Ok(Frame::new(id, bytes.get(..count).ok_or(NO_DATA)?))
}
