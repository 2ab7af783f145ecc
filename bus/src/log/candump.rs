//! can-utils: what `candump` writes into a log, and what it shows.
//!
//! ```text
//! (1436509052.249713) can0 601#4000100000000000      -l, -L; ` R` or ` T` behind it with -x
//! (1436509052.249713) can0 704#R                     a remote frame; R4 with its length
//! (1436509052.249713) can0 123##311223344            CAN FD
//! (1436509052.249713) can0 20000004#000100000000     an error frame
//!   can0  601   [8]  40 00 10 00 00 00 00 00   '@.......'
//!  (000.001200)  can0  RX - -  704   [1]  remote request
//! ```

use lexican_runtime::wire::{CanId, Frame};

use super::{
    date::date_micros,
    line::{Bytes, Line, NO_DATA, NO_IDENTIFIER, NO_TIME, OTHER_LENGTH, Words},
    number::{decimal, hexadecimal, micros},
};

/// Set in the identifier of an error frame (linux/can.h).
const ERROR_FRAME: u32 = 0x2000_0000;

/// The longest name of an interface (linux/if.h), and `any`'s and python-can's somewhat longer ones.
const LONGEST_NAME: usize = 32;

/// Reads a line of either form.
pub(super) fn parse(line: &[u8]) -> Line<'_> {
    let mut words = Words(line);
    let time = match timestamp(&mut words) {
        Ok(time) => time,
        Err(reason) => return Line::Damaged(reason),
    };
    let Some(channel) = words.next().filter(|name| name.len() <= LONGEST_NAME) else {
        return Line::Damaged("the name of the interface is missing");
    };
    let Some(id) = words.next() else {
        return Line::Damaged(NO_IDENTIFIER);
    };
    let frame = match split(id, b'#') {
        Some((id, data)) => compact(id, data),
        None => spaced(id, words),
    };
    match frame {
        Ok(Some(frame)) => Line::Frame { time, channel, frame },
        Ok(None) => Line::Other,
        Err(reason) => Line::Damaged(reason),
    }
}

/// `(1436509052.249713)` or `(2015-07-10 08:17:32.249713)` if the line begins with it; 0 if it does not.
fn timestamp(words: &mut Words<'_>) -> Result<u64, &'static str> {
    let Some(inside) = words.rest().strip_prefix(b"(") else {
        return Ok(0);
    };
    let (inside, rest) = split(inside, b')').ok_or(NO_TIME)?;
    words.0 = rest;
    let mut parts = Words(inside);
    let time = match (parts.next(), parts.next()) {
        (Some(seconds), None) => micros(seconds),
        (Some(date), Some(time)) => date_micros(date, time),
        _ => None,
    };
    time.ok_or(NO_TIME)
}

/// `601` and `4000100000000000`: the form of a log. `None` for what is no classic CAN frame.
fn compact(id: &[u8], data: &[u8]) -> Result<Option<Frame>, &'static str> {
    let Some(id) = identifier(id)? else { return Ok(None) };
    match data {
        [b'#', ..] => Ok(None),
        [b'R' | b'r', length @ ..] => remote(id, length).ok_or(NO_DATA).map(Some),
        _ => pairs(id, data).ok_or(NO_DATA).map(Some),
    }
}

/// `704` and what follows, `[1]  remote request`: the form of a terminal.
fn spaced(id: &[u8], mut words: Words<'_>) -> Result<Option<Frame>, &'static str> {
    let id = match id {
        // Direction, and flags of CAN FD.
        b"RX" | b"TX" => words.nth(2).ok_or(NO_IDENTIFIER)?,
        id => id,
    };
    let Some(id) = identifier(id)? else { return Ok(None) };
    match words.next() {
        // CAN FD has two digits.
        Some([b'[', b'0'..=b'9', b'0'..=b'9', b']']) => Ok(None),
        Some([b'[', length @ b'0'..=b'8', b']']) => listed(id, length - b'0', words).map(Some),
        _ => Err(NO_DATA),
    }
}

fn listed(id: CanId, length: u8, mut words: Words<'_>) -> Result<Frame, &'static str> {
    if words.rest().starts_with(b"remote request") {
        return Frame::remote(id, length).ok_or(OTHER_LENGTH);
    }
    let mut bytes = Bytes::default();
    for _ in 0..length {
        let byte = words.next().filter(|word| word.len() == 2).ok_or(OTHER_LENGTH)?;
        let byte = hexadecimal(byte)
            .and_then(|byte| u8::try_from(byte).ok())
            .ok_or(NO_DATA)?;
        bytes.push(byte).ok_or(NO_DATA)?;
    }
    // Behind it stands nothing, or the text of `-a`.
    if words.next().is_some_and(|word| !word.starts_with(b"'")) {
        return Err(OTHER_LENGTH);
    }
    bytes.into_frame(id).ok_or(NO_DATA)
}

/// Three digits are an identifier of 11 bits, eight one of 29; `None` for an error frame.
fn identifier(digits: &[u8]) -> Result<Option<CanId>, &'static str> {
    let number = hexadecimal(digits).ok_or(NO_IDENTIFIER)?;
    let id = match digits.len() {
        3 => CanId::standard(number),
        8 if number & ERROR_FRAME != 0 => return Ok(None),
        8 => CanId::extended(number),
        _ => None,
    };
    id.ok_or(NO_IDENTIFIER).map(Some)
}

/// The length is left out for 0; `_9` and more behind it is the raw length code of `-8`.
fn remote(id: CanId, length: &[u8]) -> Option<Frame> {
    let length = split(length, b'_').map_or(length, |(length, _)| length);
    let length = if length.is_empty() { 0 } else { decimal(length)? };
    Frame::remote(id, u8::try_from(length).ok()?)
}

/// Two digits a byte; some tools put a point between bytes.
fn pairs(id: CanId, digits: &[u8]) -> Option<Frame> {
    let mut bytes = Bytes::default();
    let mut rest = split(digits, b'_').map_or(digits, |(digits, _)| digits);
    while let [high, low, after @ ..] = rest {
        bytes.push(u8::try_from(hexadecimal(&[*high, *low])?).ok()?)?;
        rest = after.strip_prefix(b".").unwrap_or(after);
    }
    rest.is_empty().then(|| bytes.into_frame(id))?
}

fn split(text: &[u8], at: u8) -> Option<(&[u8], &[u8])> {
    let at = text.iter().position(|&byte| byte == at)?;
    Some((text.get(..at)?, text.get(at + 1..)?))
}
