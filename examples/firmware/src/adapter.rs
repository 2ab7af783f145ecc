//! The adapter's side of slcan.

use lexican_runtime::{
    Frame, Instant,
    wire::slcan::{Answer, Command, Lines},
};

use crate::uart;

/// What the host's commands have made of the adapter.
#[derive(Clone, Debug)]
pub(crate) struct Adapter {
    lines: Lines,
    state: State,
    has_timestamps: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Closed,
    Listening,
    Open,
}

impl Adapter {
    pub(crate) fn new() -> Self {
        Self {
            lines: Lines::new(),
            state: State::Closed,
            has_timestamps: false,
        }
    }

    /// Whether the host is on the bus, and with it the node.
    pub(crate) fn is_open(&self) -> bool {
        self.state != State::Closed
    }

    /// Takes a byte from the host, and answers the command that it ends; gives the frame that the command puts on the bus.
    pub(crate) fn receive(&mut self, byte: u8) -> Option<Frame> {
        let line = self.lines.push(byte)?;
        let command = Command::parse(line.as_bytes());
        let answer = command.and_then(|command| self.obey(command));
        answer.unwrap_or(Answer::Refused).tell();
        match command {
            Some(Command::Transmit(frame)) if self.state == State::Open => Some(frame),
            _ => None,
        }
    }

    /// Tells the host of a frame on the bus.
    pub(crate) fn send(&self, now: Instant, frame: &Frame) {
        let millis = (now.as_micros() / 1000 % 60_000) as u16;
        let timestamp = self.has_timestamps.then_some(millis);
        Answer::Received {
            frame: *frame,
            timestamp,
        }
        .tell();
    }

    /// The answer; `None` to what is not possible in this state.
    fn obey(&mut self, command: Command) -> Option<Answer> {
        let is_closed = self.state == State::Closed;
        match command {
            Command::Nothing => {}
            Command::Open if is_closed => self.state = State::Open,
            Command::Listen if is_closed => self.state = State::Listening,
            Command::Close if !is_closed => self.state = State::Closed,
            Command::Timestamps(on) if is_closed => self.has_timestamps = on,
            // There is no wire that has a bit rate, and nothing to filter.
            Command::BitRate(_) | Command::BitTiming(_) | Command::AcceptanceCode(_) | Command::AcceptanceMask(_)
                if is_closed => {}
            Command::Transmit(frame) if self.state == State::Open => {
                let extended = frame.id().is_extended();
                return Some(Answer::Sent { extended });
            }
            Command::Version => {
                return Some(Answer::Version {
                    hardware: 0x10,
                    software: 0x10,
                });
            }
            Command::SerialNumber => return Some(Answer::SerialNumber(*b"WDGA")),
            Command::Status if !is_closed => return Some(Answer::Status(uart::status())),
            _ => return None,
        }
        Some(Answer::Done)
    }
}

/// Over the serial line.
trait Tell {
    fn tell(self);
}

impl Tell for Answer {
    fn tell(self) {
        uart::send(self.emit().as_bytes());
    }
}
