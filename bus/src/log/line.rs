//! What a line of a log comes to.

use lexican_runtime::wire::{CanId, Frame};

/// One line, understood as far as it goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Line<'a> {
    Frame {
        /// µs; of an ASC log with relative times since the line before.
        time: u64,
        channel: &'a [u8],
        frame: Frame,
    },
    /// In order, and no classic CAN frame.
    Other,
    /// Not what the format has, and why.
    Damaged(&'static str),
}

/// The words of a line: what stands between blanks.
#[derive(Clone, Debug)]
pub(super) struct Words<'a>(pub(super) &'a [u8]);

impl<'a> Words<'a> {
    /// What is left of the line.
    pub(super) const fn rest(&self) -> &'a [u8] {
        self.0.trim_ascii_start()
    }
}

impl<'a> Iterator for Words<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        let line = self.0.trim_ascii_start();
        let end = line.iter().position(u8::is_ascii_whitespace).unwrap_or(line.len());
        let (word, rest) = line.split_at_checked(end)?;
        self.0 = rest;
        (!word.is_empty()).then_some(word)
    }
}

/// A frame whose bytes come one by one.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bytes {
    data: [u8; 8],
    length: usize,
}

impl Bytes {
    /// `None` when there are eight already.
    pub(super) fn push(&mut self, byte: u8) -> Option<()> {
        *self.data.get_mut(self.length)? = byte;
        self.length += 1;
        Some(())
    }

    pub(super) fn into_frame(self, id: CanId) -> Option<Frame> {
        Frame::new(id, self.data.get(..self.length)?)
    }
}

pub(super) const NO_IDENTIFIER: &str = "the identifier is none";
pub(super) const NO_DATA: &str = "the data are not up to eight bytes";
pub(super) const NO_TIME: &str = "the time is none";
pub(super) const OTHER_LENGTH: &str = "there are not as many bytes as the line says";
