//! slcan: frames as lines of text, to an adapter or another program.

mod listener;
mod serial;
mod socket;

use std::{
    io::{self, ErrorKind, Read, Write},
    time::{Duration, Instant},
};

use lexican_runtime::wire::{
    Frame,
    slcan::{Answer, Command, Line, Lines},
};

use super::{Error, Transport, url::BitRate};

pub(super) use listener::Listener;
pub(super) use serial::Serial;
pub(super) use socket::Socket;

/// Bytes both ways, with a limit to how long a read waits.
pub(super) trait Stream: Read + Write + Send {
    /// From now on, a read that finds nothing within `patience` fails as [`ErrorKind::WouldBlock`] or
    /// [`ErrorKind::TimedOut`]; with no patience at all it looks, and does not wait. A read of 0 bytes is the end.
    fn set_patience(&mut self, patience: Duration) -> io::Result<()>;
}

/// The host's end of an slcan line.
#[derive(Debug)]
pub(super) struct Slcan<S> {
    bus: String,
    stream: S,
    lines: Lines,
    /// What has been read and not yet been gathered to lines.
    unread: Unread,
    handshake: Handshake,
}

/// How many answers to the first commands have not come; the last of them is the one to `O`. An adapter need not answer.
type Handshake = usize;

impl<S: Stream> Slcan<S> {
    /// Ends what the adapter may be doing, and goes on the bus: `CR`, `C`, `Sn`, `O`.
    pub(super) fn open(bus: String, stream: S, bit_rate: Option<BitRate>) -> Result<Self, Error> {
        let mut slcan = Self {
            bus,
            stream,
            lines: Lines::new(),
            unread: Unread::default(),
            handshake: 0,
        };
        let bit_rate = bit_rate.map(|rate| Command::BitRate(rate.digit()));
        let commands = [
            Some(Command::Nothing),
            Some(Command::Close),
            bit_rate,
            Some(Command::Open),
        ];
        for command in commands.into_iter().flatten() {
            slcan.command(command).map_err(|cause| slcan.error("open", cause))?;
            slcan.handshake += 1;
        }
        Ok(slcan)
    }

    fn command(&mut self, command: Command) -> io::Result<()> {
        self.stream.write_all(command.emit().as_bytes())?;
        self.stream.flush()
    }

    /// The next frame among the bytes that have been read.
    fn next_frame(&mut self) -> io::Result<Option<Frame>> {
        while let Some(byte) = self.unread.next() {
            let Some(line) = self.lines.push(byte) else { continue };
            if let Some(frame) = self.heed(line)? {
                return Ok(Some(frame));
            }
        }
        Ok(None)
    }

    /// A frame is given; of the answers only the one to `O` matters.
    fn heed(&mut self, line: Line) -> io::Result<Option<Frame>> {
        match Answer::parse(line.as_bytes()) {
            Some(Answer::Received { frame, .. }) => {
                self.handshake = 0;
                Ok(Some(frame))
            }
            Some(answer @ (Answer::Done | Answer::Refused)) if self.handshake > 0 => {
                self.handshake -= 1;
                if self.handshake == 0 && answer == Answer::Refused {
                    return Err(io::Error::other(
                        "the adapter does not go on the bus; name its bit rate, as in …@500k",
                    ));
                }
                Ok(None)
            }
            _ => Ok(None),
        }
    }

    /// Takes what comes within `patience`.
    fn read(&mut self, patience: Duration) -> io::Result<()> {
        self.stream.set_patience(patience)?;
        match self.unread.fill(&mut self.stream) {
            Err(error) if is_nothing_yet(&error) => Ok(()),
            result => result,
        }
    }

    fn receive_until(&mut self, end: Instant) -> io::Result<Option<Frame>> {
        loop {
            if let Some(frame) = self.next_frame()? {
                return Ok(Some(frame));
            }
            let patience = end.saturating_duration_since(Instant::now());
            self.read(patience)?;
            if patience.is_zero() {
                return self.next_frame();
            }
        }
    }

    fn error(&self, what: &'static str, cause: io::Error) -> Error {
        let bus = self.bus.clone();
        Error { bus, what, cause }
    }
}

impl<S: Stream> Transport for Slcan<S> {
    fn send(&mut self, frame: &Frame) -> Result<(), Error> {
        let sent = self.command(Command::Transmit(*frame));
        sent.map_err(|cause| self.error("send a frame", cause))
    }

    fn receive(&mut self, patience: Duration) -> Result<Option<Frame>, Error> {
        let now = Instant::now();
        let end = now
            .checked_add(patience)
            .unwrap_or_else(|| now + Duration::from_secs(u64::from(u32::MAX)));
        let frame = self.receive_until(end);
        frame.map_err(|cause| self.error("receive", cause))
    }
}

fn is_nothing_yet(error: &io::Error) -> bool {
    matches!(
        error.kind(),
        ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted
    )
}

/// Bytes on their way from a stream to lines.
#[derive(Debug)]
struct Unread {
    bytes: Box<[u8; 4096]>,
    next: usize,
    end: usize,
}

impl Default for Unread {
    fn default() -> Self {
        Self {
            bytes: Box::new([0; 4096]),
            next: 0,
            end: 0,
        }
    }
}

impl Unread {
    /// Reads once; all that was read before has been taken.
    fn fill(&mut self, stream: &mut impl Read) -> io::Result<()> {
        (self.next, self.end) = (0, 0);
        self.end = stream.read(self.bytes.as_mut_slice())?;
        if self.end == 0 {
            return Err(io::Error::new(
                ErrorKind::UnexpectedEof,
                "the other side has closed the connection",
            ));
        }
        Ok(())
    }
}

impl Iterator for Unread {
    type Item = u8;

    fn next(&mut self) -> Option<u8> {
        let byte = self.bytes.get(self.next..self.end)?.first();
        self.next += 1;
        byte.copied()
    }
}
