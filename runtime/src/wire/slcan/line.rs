//! A line: gathered byte by byte, or written digit by digit.

use core::fmt;

use super::{END, REFUSAL};

/// As long as the longest line: `T`, eight digits of identifier, one of length, sixteen of data, four of time, CR.
const LENGTH: usize = 31;

/// A line of slcan.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Line {
    bytes: [u8; LENGTH],
    length: u8,
}

impl Line {
    /// A line that starts with `letter`.
    pub(super) const fn new(letter: u8) -> Self {
        let mut bytes = [0; LENGTH];
        bytes[0] = letter;
        Self { bytes, length: 1 }
    }

    const EMPTY: Self = Self {
        bytes: [0; LENGTH],
        length: 0,
    };

    /// The bytes; those that are to be sent end with [`END`] or are [`REFUSAL`].
    #[must_use]
    pub fn as_bytes(&self) -> &[u8] {
        self.bytes.get(..usize::from(self.length)).unwrap_or(&self.bytes)
    }

    /// The same with `byte` behind it. No line that this module writes is too long.
    pub(super) fn with(mut self, byte: u8) -> Self {
        self.push(byte);
        self
    }

    /// The same with the lowest `count` hexadecimal digits of `number` behind it.
    pub(super) fn with_digits(self, number: u32, count: u32) -> Self {
        (0..count).rev().fold(self, |line, place| {
            let digit = (number >> (4 * place) & 0xF) as u8;
            line.with(if digit < 10 { b'0' + digit } else { b'A' + digit - 10 })
        })
    }

    /// `false` when the line is full.
    fn push(&mut self, byte: u8) -> bool {
        let Some(place) = self.bytes.get_mut(usize::from(self.length)) else {
            return false;
        };
        *place = byte;
        self.length += 1;
        true
    }
}

impl fmt::Debug for Line {
    /// As a string: `"t7041007F\r"`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\"{}\"", self.as_bytes().escape_ascii())
    }
}

/// Gathers what comes in to lines.
///
/// ```
/// use lexican_runtime::wire::slcan::{Command, Lines};
///
/// let mut lines = Lines::new();
/// let mut commands = b"S6\rO\r".iter().filter_map(|&byte| lines.push(byte));
/// assert_eq!(Command::parse(commands.next().unwrap().as_bytes()), Some(Command::BitRate(6)));
/// assert_eq!(Command::parse(commands.next().unwrap().as_bytes()), Some(Command::Open));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Lines {
    line: Line,
    is_too_long: bool,
}

impl Lines {
    /// Nothing has come in.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            line: Line::EMPTY,
            is_too_long: false,
        }
    }

    /// Takes a byte, and gives the line that it ends: [`END`] is left out, [`REFUSAL`] is a line and ends whatever came
    /// before it. Line feeds mean nothing. Of a line that is longer than any of slcan only the letter is given, so that
    /// it is refused once, not understood as another.
    pub fn push(&mut self, byte: u8) -> Option<Line> {
        match byte {
            END => Some(self.take()),
            REFUSAL => {
                self.take();
                Some(Line::new(REFUSAL))
            }
            b'\n' => None,
            byte => {
                self.is_too_long |= !self.line.push(byte);
                None
            }
        }
    }

    /// The line so far; the next one begins.
    fn take(&mut self) -> Line {
        let whole = core::mem::take(self);
        if whole.is_too_long {
            return Line::new(b'?');
        }
        whole.line
    }
}

impl Default for Lines {
    fn default() -> Self {
        Self::new()
    }
}

/// What is left to read of a line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Digits<'a>(pub(super) &'a [u8]);

impl Digits<'_> {
    /// The next `count` hexadecimal digits, up to eight, as a number.
    pub(super) fn number(&mut self, count: usize) -> Option<u32> {
        let digits = self.0.get(..count)?;
        self.0 = self.0.get(count..)?;
        digits
            .iter()
            .try_fold(0, |number, &digit| Some(number << 4 | char::from(digit).to_digit(16)?))
    }

    /// `value`, when nothing is left.
    pub(super) fn end<T>(self, value: T) -> Option<T> {
        self.0.is_empty().then_some(value)
    }
}
