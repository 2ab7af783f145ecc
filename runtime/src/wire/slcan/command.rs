//! What a host tells an adapter.

use super::{
    frame,
    line::{Digits, Line},
    END,
};
use crate::wire::Frame;

/// A command to an adapter. Its answer is [`Answer::Done`](super::Answer::Done) or
/// [`Answer::Refused`](super::Answer::Refused) where nothing else is said.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Command {
    /// An empty line, which a host sends to end whatever the adapter had half received.
    Nothing,
    /// `O`: go on the bus.
    Open,
    /// `L`: go on the bus, but only listen.
    Listen,
    /// `C`: leave the bus.
    Close,
    /// `S0` to `S8`: 10, 20, 50, 100, 125, 250, 500, 800, 1000 kbit/s. Only while closed.
    BitRate(u8),
    /// `sxxyy`: the registers BTR0 (high byte) and BTR1 (low byte) of an SJA1000. Only while closed.
    BitTiming(u16),
    /// `t`, `T`, `r`, `R`: send a frame; answered with [`Answer::Sent`](super::Answer::Sent).
    Transmit(Frame),
    /// `F`: read and clear the errors; answered with [`Answer::Status`](super::Answer::Status).
    Status,
    /// `V`: answered with [`Answer::Version`](super::Answer::Version).
    Version,
    /// `N`: answered with [`Answer::SerialNumber`](super::Answer::SerialNumber).
    SerialNumber,
    /// `Z0`, `Z1`: whether received frames carry a time. Only while closed.
    Timestamps(bool),
    /// `Mxxxxxxxx`: the acceptance code of an SJA1000. Only while closed.
    AcceptanceCode(u32),
    /// `mxxxxxxxx`: the acceptance mask of an SJA1000. Only while closed.
    AcceptanceMask(u32),
}

impl Command {
    /// What `line`, without its [`END`], says; `None` when it is no command.
    #[must_use]
    pub fn parse(line: &[u8]) -> Option<Self> {
        let Some((&letter, digits)) = line.split_first() else {
            return Some(Self::Nothing);
        };
        let mut digits = Digits(digits);
        let command = match letter {
            b'O' => Self::Open,
            b'L' => Self::Listen,
            b'C' => Self::Close,
            b'F' => Self::Status,
            b'V' => Self::Version,
            b'N' => Self::SerialNumber,
            b'S' => Self::BitRate(rate(digits.number(1)?)?),
            b's' => Self::BitTiming(u16::try_from(digits.number(4)?).ok()?),
            b'Z' => Self::Timestamps(switch(digits.number(1)?)?),
            b'M' => Self::AcceptanceCode(digits.number(8)?),
            b'm' => Self::AcceptanceMask(digits.number(8)?),
            b't' | b'T' | b'r' | b'R' => Self::Transmit(frame::parse(letter, &mut digits)?),
            _ => return None,
        };
        digits.end(command)
    }

    /// The line that says it, with its [`END`].
    #[must_use]
    pub fn emit(&self) -> Line {
        let line = match *self {
            Self::Nothing => return Line::new(END),
            Self::Open => Line::new(b'O'),
            Self::Listen => Line::new(b'L'),
            Self::Close => Line::new(b'C'),
            Self::Status => Line::new(b'F'),
            Self::Version => Line::new(b'V'),
            Self::SerialNumber => Line::new(b'N'),
            Self::BitRate(rate) => Line::new(b'S').with_digits(u32::from(rate), 1),
            Self::BitTiming(registers) => Line::new(b's').with_digits(u32::from(registers), 4),
            Self::Timestamps(on) => Line::new(b'Z').with_digits(u32::from(on), 1),
            Self::AcceptanceCode(code) => Line::new(b'M').with_digits(code, 8),
            Self::AcceptanceMask(mask) => Line::new(b'm').with_digits(mask, 8),
            Self::Transmit(frame) => frame::emit(&frame),
        };
        line.with(END)
    }
}

/// 0 to 8.
fn rate(number: u32) -> Option<u8> {
    u8::try_from(number).ok().filter(|rate| *rate <= 8)
}

/// 0 or 1.
fn switch(number: u32) -> Option<bool> {
    match number {
        0 => Some(false),
        1 => Some(true),
        _ => None,
    }
}
