//! What an adapter tells its host.

use super::{
    frame,
    line::{Digits, Line},
    END, REFUSAL,
};
use crate::wire::Frame;

/// An answer of an adapter, or a frame that came from the bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Answer {
    /// An empty line: the command was obeyed.
    Done,
    /// BEL: the command was not understood, or is not possible now.
    Refused,
    /// `z` or, when it was `extended`, `Z`: the frame was sent.
    Sent {
        /// Whether its identifier has 29 bits.
        extended: bool,
    },
    /// `t`, `T`, `r`, `R`: a frame came from the bus.
    Received {
        /// The frame.
        frame: Frame,
        /// When, in ms, `0..=59_999`; only with `Z1`.
        timestamp: Option<u16>,
    },
    /// `Vhhss`: versions of hardware and software, two digits each.
    Version {
        /// The hardware's, major in the high four bits.
        hardware: u8,
        /// The software's, major in the high four bits.
        software: u8,
    },
    /// `Naaaa`: four characters that are the adapter's own.
    SerialNumber([u8; 4]),
    /// `Fxx`: bit 0 receive queue full, 1 transmit queue full, 2 error warning, 3 data overrun, 5 error passive,
    /// 6 arbitration lost, 7 bus error.
    Status(u8),
}

impl Answer {
    /// What `line`, without its [`END`], says; `None` when it is no answer.
    #[must_use]
    pub fn parse(line: &[u8]) -> Option<Self> {
        let Some((&letter, digits)) = line.split_first() else {
            return Some(Self::Done);
        };
        let mut digits = Digits(digits);
        let answer = match letter {
            REFUSAL => Self::Refused,
            b'z' | b'Z' => Self::Sent {
                extended: letter == b'Z',
            },
            b'V' => Self::Version {
                hardware: byte(&mut digits)?,
                software: byte(&mut digits)?,
            },
            b'N' => return Some(Self::SerialNumber(digits.0.try_into().ok()?)),
            b'F' => Self::Status(byte(&mut digits)?),
            b't' | b'T' | b'r' | b'R' => received(letter, &mut digits)?,
            _ => return None,
        };
        digits.end(answer)
    }

    /// The line that says it, with its [`END`].
    #[must_use]
    pub fn emit(&self) -> Line {
        let line = match *self {
            Self::Done => return Line::new(END),
            Self::Refused => return Line::new(REFUSAL),
            Self::Sent { extended } => Line::new(if extended { b'Z' } else { b'z' }),
            Self::Version { hardware, software } => Line::new(b'V')
                .with_digits(u32::from(hardware), 2)
                .with_digits(u32::from(software), 2),
            Self::SerialNumber(characters) => characters.into_iter().fold(Line::new(b'N'), Line::with),
            Self::Status(flags) => Line::new(b'F').with_digits(u32::from(flags), 2),
            Self::Received { frame, timestamp } => {
                let line = frame::emit(&frame);
                timestamp.map_or(line, |time| line.with_digits(u32::from(time), 4))
            }
        };
        line.with(END)
    }
}

fn byte(digits: &mut Digits<'_>) -> Option<u8> {
    u8::try_from(digits.number(2)?).ok()
}

/// A frame, with four digits of time behind it or without.
fn received(letter: u8, digits: &mut Digits<'_>) -> Option<Answer> {
    let frame = frame::parse(letter, digits)?;
    let timestamp = if digits.0.is_empty() {
        None
    } else {
        Some(u16::try_from(digits.number(4)?).ok()?)
    };
    Some(Answer::Received { frame, timestamp })
}
