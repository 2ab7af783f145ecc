//! A frame in a line: the same in both directions.
//!
//! ```text
//! t iii l dd…          data frame, 11 bits
//! T iiiiiiii l dd…     data frame, 29 bits
//! r iii l              remote frame, 11 bits
//! R iiiiiiii l         remote frame, 29 bits
//! ```

use super::line::{Digits, Line};
use crate::wire::{CanId, Frame};

/// Reads the frame that starts with `letter`.
pub(super) fn parse(letter: u8, digits: &mut Digits<'_>) -> Option<Frame> {
    let id = if letter.is_ascii_uppercase() {
        CanId::extended(digits.number(8)?)?
    } else {
        CanId::standard(digits.number(3)?)?
    };
    let length = digits.number(1)?;
    if letter.eq_ignore_ascii_case(&b'r') {
        return Frame::remote(id, u8::try_from(length).ok()?);
    }
    let mut data = [0; 8];
    let data = data.get_mut(..usize::try_from(length).ok()?)?;
    for byte in data.iter_mut() {
        *byte = u8::try_from(digits.number(2)?).ok()?;
    }
    Frame::new(id, data)
}

/// Writes a frame, without the end of the line.
pub(super) fn emit(frame: &Frame) -> Line {
    let id = frame.id();
    let (remote, data, digits) = if id.is_extended() {
        (b'R', b'T', 8)
    } else {
        (b'r', b't', 3)
    };
    let line = Line::new(if frame.is_remote() { remote } else { data })
        .with_digits(id.number(), digits)
        .with_digits(u32::try_from(frame.length()).unwrap_or(8), 1);
    frame
        .data()
        .iter()
        .fold(line, |line, &byte| line.with_digits(u32::from(byte), 2))
}
