//! Logs of a bus: read line by line, whatever tool wrote them, and written as candump does.
//!
//! | module | reads |
//! |---|---|
//! | `candump` | can-utils: the log of `candump -l`, and what `candump` shows on a terminal |
//! | `asc` | Vector's ASC, as CANalyzer, CANoe and python-can write it |
//! | `csv` | python-can's CSV |
//!
//! A log is told by what is in it, not by its file's name. What is no classic CAN frame (CAN FD, error frames, events of a
//! tool) is passed over; a line that is damaged is counted, remembered by its number, and passed over too. Memory does not
//! grow with the log.

mod asc;
mod candump;
mod csv;
mod date;
mod line;
mod number;
mod reader;
mod summary;
mod writer;

use std::fmt;

use lexican_runtime::{Instant, wire::Frame};

pub use reader::Reader;
pub use summary::{Damage, Summary};
pub use writer::Writer;

/// A frame of a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Record {
    /// When, as the log counts: since 1970 for most, since the beginning of the measurement for ASC. 0 in a log without times.
    pub time: Instant,
    /// On which of the buses that the log has.
    pub channel: Channel,
    /// The frame.
    pub frame: Frame,
}

/// A bus of a log; [`Reader::channel_name`] knows what the log calls it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Channel(u8);

impl Channel {
    /// Which one it is, from 0, in the order in which they appear in the log.
    #[must_use]
    pub const fn number(self) -> usize {
        self.0 as usize
    }
}

/// Who wrote a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// can-utils: `(1436509052.249713) can0 601#4000100000000000`, or `can0  601   [8]  40 00 10 00 00 00 00 00`.
    Candump,
    /// Vector: `0.012345 1  601  Rx   d 8 40 00 10 00 00 00 00 00`.
    Asc,
    /// python-can: `1436509052.249713,0x601,0,0,0,8,QAAQAAAAAAA=`.
    Csv,
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Candump => "candump log",
            Self::Asc => "Vector ASC log",
            Self::Csv => "CSV log of python-can",
        })
    }
}
