//! Vector's ASC, of which python-can writes a part too.
//!
//! ```text
//! date Mon Nov 23 11:02:03.123 am 2026
//! base hex  timestamps absolute
//!    0.012345 1  601             Rx   d 8 40 00 10 00 00 00 00 00  Length = 228000 BitCount = 118
//!    0.013000 1  18FEDF00x       Tx   r 2
//!    0.013500 1  ErrorFrame
//!    0.014000 CANFD   1 Rx  181  name  0 0 8 8 01 02 03 04 05 06 07 08 0 0 1000 0 0 0 0 0
//!    0.015000 1  Statistic: D 2 R 0 XD 0 XR 0 E 0 O 0 B 0.46%
//! ```

use lexican_runtime::wire::{CanId, Frame};

use super::{
    line::{Bytes, Line, NO_DATA, NO_IDENTIFIER, OTHER_LENGTH, Words},
    number::{decimal, hexadecimal, micros},
};

/// Set in the flags of a line `CANFD`: the frame is one. Without it the line tells of a classic frame.
const EXTENDED_DATA_LENGTH: u32 = 1 << 12;
/// Set in the flags of a line `CANFD`: a remote frame.
const REMOTE: u32 = 1 << 4;

/// What the header of the log has said.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Header {
    /// Identifiers and data are decimal.
    decimal: bool,
    /// Times count from the line before.
    pub(super) relative: bool,
}

impl Header {
    pub(super) const DEFAULT: Self = Self {
        decimal: false,
        relative: false,
    };

    fn number(self, digits: &[u8]) -> Option<u32> {
        if self.decimal {
            decimal(digits)
        } else {
            hexadecimal(digits)
        }
    }
}

/// Reads a line; one of the header changes `header`.
pub(super) fn parse<'a>(line: &'a [u8], header: &mut Header) -> Line<'a> {
    let mut words = Words(line);
    let Some(first) = words.next() else { return Line::Other };
    if !first.starts_with(b"//") && first.first().is_some_and(u8::is_ascii_digit) {
        return match micros(first) {
            Some(time) => event(time, words, *header),
            None => Line::Damaged("the line does not begin with a time"),
        };
    }
    if is_base(first) {
        header.decimal = words.next().is_some_and(|base| base.eq_ignore_ascii_case(b"dec"));
        header.relative = words.any(|word| word.eq_ignore_ascii_case(b"relative"));
        return Line::Other;
    }
    if is_header(first) {
        return Line::Other;
    }
    Line::Damaged("the line does not begin with a time")
}

/// Whether `line` is one that no other format has.
pub(super) fn is_beginning(line: &[u8]) -> bool {
    let mut words = Words(line);
    let first = words.next().unwrap_or_default();
    first.eq_ignore_ascii_case(b"date") || is_base(first) && words.next().is_some_and(is_number_base)
}

fn is_base(word: &[u8]) -> bool {
    word.eq_ignore_ascii_case(b"base")
}

fn is_number_base(word: &[u8]) -> bool {
    word.eq_ignore_ascii_case(b"hex") || word.eq_ignore_ascii_case(b"dec")
}

/// A comment, or one of the lines around the measurement.
fn is_header(first: &[u8]) -> bool {
    const KNOWN: [&[u8]; 6] = [b"date", b"internal", b"no", b"begin", b"end", b"previous"];
    first.starts_with(b"//") || KNOWN.iter().any(|known| first.eq_ignore_ascii_case(known))
}

/// What follows the time.
fn event(time: u64, mut words: Words<'_>, header: Header) -> Line<'_> {
    let frame = match words.next() {
        Some(b"CANFD") => fd(words, header),
        Some(channel) if decimal(channel).is_some() => {
            classic(words, header).map(|frame| frame.map(|frame| (channel, frame)))
        }
        _ => Ok(None),
    };
    match frame {
        Ok(Some((channel, frame))) => Line::Frame { time, channel, frame },
        Ok(None) => Line::Other,
        Err(reason) => Line::Damaged(reason),
    }
}

type Found<T> = Result<Option<T>, &'static str>;

/// `601  Rx  d 8 40 00 …`; `None` for what has no direction: error frames, statistics.
fn classic(mut words: Words<'_>, header: Header) -> Found<Frame> {
    let (Some(id), Some(direction)) = (words.next(), words.next()) else {
        return Ok(None);
    };
    if !is_direction(direction) {
        return Ok(None);
    }
    let id = identifier(id, header).ok_or(NO_IDENTIFIER)?;
    let kind = words.next().ok_or(NO_DATA)?;
    let length = words.next().map(hexadecimal);
    match (kind, length) {
        // Old versions do not write the length.
        (b"r" | b"R", None) => Ok(Frame::remote(id, 0)),
        (b"r" | b"R", Some(length)) => Ok(Frame::remote(id, length.map_or(0, eight_at_most))),
        (b"d" | b"D", Some(Some(length))) => data(id, eight_at_most(length), &mut words, header).map(Some),
        _ => Err(NO_DATA),
    }
}

fn is_direction(word: &[u8]) -> bool {
    [&b"Rx"[..], b"Tx", b"TxRq"]
        .iter()
        .any(|known| word.eq_ignore_ascii_case(known))
}

/// `18FEDF00x` has 29 bits.
fn identifier(word: &[u8], header: Header) -> Option<CanId> {
    match word.strip_suffix(b"x") {
        Some(digits) => CanId::extended(header.number(digits)?),
        None => CanId::standard(header.number(word)?),
    }
}

/// Length codes above 8 stand for eight bytes (ISO 11898-1).
fn eight_at_most(length: u32) -> u8 {
    u8::try_from(length).unwrap_or(8).min(8)
}

fn data(id: CanId, length: u8, words: &mut Words<'_>, header: Header) -> Result<Frame, &'static str> {
    let mut bytes = Bytes::default();
    for _ in 0..length {
        let byte = words.next().ok_or(OTHER_LENGTH)?;
        let byte = header
            .number(byte)
            .and_then(|byte| u8::try_from(byte).ok())
            .ok_or(NO_DATA)?;
        bytes.push(byte).ok_or(NO_DATA)?;
    }
    bytes.into_frame(id).ok_or(NO_DATA)
}

/// `1 Rx 181 name 0 0 8 8 01 … 0 0 1000 …`: channel, direction, identifier, perhaps a name, BRS, ESI, length code, number
/// of bytes, bytes, duration, length, flags. Tools that record FD channels write classic frames so, too.
fn fd(mut words: Words<'_>, header: Header) -> Found<(&[u8], Frame)> {
    let channel = words.next().ok_or("the channel is missing")?;
    let (Some(direction), Some(id)) = (words.next(), words.next()) else {
        return Err(NO_IDENTIFIER);
    };
    if !is_direction(direction) || id.eq_ignore_ascii_case(b"ErrorFrame") {
        return Ok(None);
    }
    let id = identifier(id, header).ok_or(NO_IDENTIFIER)?;
    // The name is left out when there is none; BRS is 0 or 1.
    let second = words.next().ok_or(NO_DATA)?;
    if !matches!(second, b"0" | b"1") {
        words.next();
    }
    words.next();
    let length = words.next().and_then(hexadecimal).ok_or(OTHER_LENGTH)?;
    let number = words.next().and_then(decimal).ok_or(OTHER_LENGTH)?;
    let Some(number) = u8::try_from(number).ok().filter(|&number| number <= 8) else {
        return Ok(None);
    };
    let frame = data(id, number, &mut words, header)?;
    let flags = words.nth(2).and_then(hexadecimal).ok_or("the flags are missing")?;
    Ok(match flags {
        fd if fd & EXTENDED_DATA_LENGTH != 0 => None,
        remote if remote & REMOTE != 0 => Frame::remote(id, eight_at_most(length)).map(|frame| (channel, frame)),
        _ => Some((channel, frame)),
    })
}
