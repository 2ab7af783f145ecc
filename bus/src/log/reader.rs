//! From text to frames.

use std::io::{self, BufRead, BufReader, ErrorKind, Read};

use lexican_runtime::Instant;

use super::{
    Channel, Format, Record, Summary,
    asc::{self, Header},
    candump, csv,
    line::Line,
};

/// No line of a log is longer; what is, is no line of a log, and shall not fill the memory.
const LONGEST_LINE: u64 = 4096;

/// After so many lines, none of which is of any log, this is no log.
const PATIENCE: u64 = 10_000;

/// More buses than that no tool records at once; a damaged log can make up names without end.
const MOST_CHANNELS: usize = 64;

/// Reads a log, a line at a time.
#[derive(Debug)]
pub struct Reader<R> {
    text: R,
    line: Vec<u8>,
    format: Option<Format>,
    header: Header,
    time: u64,
    channels: Vec<String>,
    summary: Summary,
}

impl<R: BufRead> Reader<R> {
    /// Reads `text`, which is a log of any [`Format`].
    pub const fn new(text: R) -> Self {
        Self {
            text,
            line: Vec::new(),
            format: None,
            header: Header::DEFAULT,
            time: 0,
            channels: Vec::new(),
            summary: Summary {
                lines: 0,
                frames: 0,
                passed_over: 0,
                damaged: 0,
                damages: Vec::new(),
            },
        }
    }

    /// What the log is; `None` as long as no line has told.
    pub const fn format(&self) -> Option<Format> {
        self.format
    }

    /// What has become of the lines so far.
    pub const fn summary(&self) -> &Summary {
        &self.summary
    }

    /// What the log calls `channel`: `can0`; `1` in ASC.
    pub fn channel_name(&self, channel: Channel) -> &str {
        self.channels.get(channel.number()).map_or("", String::as_str)
    }

    /// The next frame; `None` at the end of the log.
    ///
    /// # Errors
    /// When the text cannot be read; of kind [`ErrorKind::InvalidData`] when it is no log: ten thousand lines or all of them
    /// are of no format.
    pub fn next_record(&mut self) -> io::Result<Option<Record>> {
        while self.read_line()? {
            if let Some(record) = self.record() {
                self.summary.frames += 1;
                return Ok(Some(record));
            }
            if self.format.is_none() && self.summary.damaged >= PATIENCE {
                return Err(no_log());
            }
        }
        if self.format.is_none() && self.summary.damaged > 0 {
            return Err(no_log());
        }
        Ok(None)
    }

    /// Fills `line` with the next line, without its end; `false` when there is none.
    fn read_line(&mut self) -> io::Result<bool> {
        self.line.clear();
        let mut text = self.text.by_ref().take(LONGEST_LINE);
        if text.read_until(b'\n', &mut self.line)? == 0 {
            return Ok(false);
        }
        self.summary.lines += 1;
        if self.line.pop_if(|last| *last == b'\n').is_none() && text.limit() == 0 {
            self.text.skip_until(b'\n')?;
        }
        Ok(true)
    }

    fn record(&mut self) -> Option<Record> {
        if self.summary.lines == 1 && self.line.starts_with(b"\xEF\xBB\xBF") {
            self.line.drain(..3);
        }
        if self.line.contains(&0x1B) {
            remove_colours(&mut self.line);
        }
        let line = self.line.trim_ascii();
        let format = self.format.or_else(|| recognise(line));
        let line = match format {
            _ if line.is_empty() => Line::Other,
            Some(Format::Candump) => candump::parse(line),
            Some(Format::Asc) => asc::parse(line, &mut self.header),
            Some(Format::Csv) => csv::parse(line),
            None if line.starts_with(b"//") => Line::Other,
            None => Line::Damaged("the line is of no log that is known"),
        };
        self.format = format;
        match line {
            Line::Other => self.summary.passed_over += 1,
            Line::Damaged(reason) => self.summary.damage(reason),
            Line::Frame { time, channel, frame } => {
                let Some(channel) = find_channel(&mut self.channels, channel) else {
                    self.summary
                        .damage("the bus has no name, or is one more than any tool records");
                    return None;
                };
                self.time = if self.header.relative {
                    self.time.saturating_add(time)
                } else {
                    time
                };
                let time = Instant::from_micros(self.time);
                return Some(Record { time, channel, frame });
            }
        }
        None
    }
}

impl<T: Read> Reader<BufReader<T>> {
    /// Whether the next line is in memory, so that reading it does not wait.
    pub fn has_next_line(&self) -> bool {
        self.text.buffer().contains(&b'\n')
    }
}

impl<R: BufRead> Iterator for Reader<R> {
    type Item = io::Result<Record>;

    fn next(&mut self) -> Option<Self::Item> {
        self.next_record().transpose()
    }
}

fn no_log() -> io::Error {
    let sentence = "this is no log of candump, no Vector ASC and no CSV of python-can";
    io::Error::new(ErrorKind::InvalidData, sentence)
}

/// The format that `line` is of, if it can be told.
fn recognise(line: &[u8]) -> Option<Format> {
    let is_frame = |line| matches!(line, Line::Frame { .. });
    if asc::is_beginning(line) || is_frame(asc::parse(line, &mut Header::DEFAULT.clone())) {
        return Some(Format::Asc);
    }
    if csv::is_beginning(line) || is_frame(csv::parse(line)) {
        return Some(Format::Csv);
    }
    is_frame(candump::parse(line)).then_some(Format::Candump)
}

/// The channel of that name; `None` for one too many, and for a name that is no text.
fn find_channel(channels: &mut Vec<String>, name: &[u8]) -> Option<Channel> {
    let known = channels.iter().position(|known| known.as_bytes() == name);
    let number = match known {
        Some(number) => number,
        None if channels.len() < MOST_CHANNELS => {
            channels.push(str::from_utf8(name).ok()?.to_owned());
            channels.len() - 1
        }
        None => return None,
    };
    u8::try_from(number).ok().map(Channel)
}

/// Takes out what `candump -c` paints with: `ESC [ … m`.
fn remove_colours(line: &mut Vec<u8>) {
    let mut is_inside = false;
    line.retain(|&byte| {
        let was_inside = is_inside;
        is_inside = byte == 0x1B || is_inside && byte != b'm';
        !was_inside && !is_inside
    });
}
