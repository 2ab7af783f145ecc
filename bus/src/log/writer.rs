//! From frames to text.

use std::io::{self, Write};

use lexican_runtime::{Instant, wire::Frame};

/// Writes a log as `candump -l` does, which can-utils, python-can and this crate read.
#[derive(Debug)]
pub struct Writer<W> {
    text: W,
    channel: String,
}

impl<W: Write> Writer<W> {
    /// Writes to `text` what happens on the bus `channel`, such as `can0`; blanks in the name become `_`.
    pub fn new(text: W, channel: &str) -> Self {
        let channel = channel.replace(|c: char| c.is_whitespace() || c.is_control() || c == '#', "_");
        Self { text, channel }
    }

    /// Writes a line; `time` counts since 1970.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn write(&mut self, time: Instant, frame: &Frame) -> io::Result<()> {
        let (seconds, micros) = (time.as_micros() / 1_000_000, time.as_micros() % 1_000_000);
        writeln!(self.text, "({seconds:010}.{micros:06}) {} {frame:?}", self.channel)
    }

    /// Writes what is held back.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn flush(&mut self) -> io::Result<()> {
        self.text.flush()
    }

    /// What is written to.
    pub fn into_inner(self) -> W {
        self.text
    }
}
