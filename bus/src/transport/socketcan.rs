//! Linux's own CAN interfaces.

use std::{io, time::Duration};

use lexican_runtime::wire::Frame;
use socketcan::{CanFrame, CanSocket, EmbeddedFrame, Socket};

use super::{Error, Transport};

/// How long to wait while the interface's queue is full, as on a bus where nobody acknowledges.
const STALLED: Duration = Duration::from_secs(1);

/// An interface such as `can0` or `vcan0`.
pub(super) struct SocketCan {
    bus: String,
    socket: CanSocket,
}

impl SocketCan {
    /// Opens `interface`, which is to be up: its bit rate is the system's affair.
    pub(super) fn open(bus: String, interface: &str) -> Result<Self, Error> {
        match connect(interface) {
            Ok(socket) => Ok(Self { bus, socket }),
            Err(cause) => Err(Error {
                bus,
                what: "open",
                cause,
            }),
        }
    }

    fn failed(&self, what: &'static str, cause: io::Error) -> Error {
        let bus = self.bus.clone();
        Error { bus, what, cause }
    }
}

fn connect(interface: &str) -> io::Result<CanSocket> {
    let socket = CanSocket::open(interface)?;
    socket.set_write_timeout(STALLED)?;
    Ok(socket)
}

impl Transport for SocketCan {
    fn send(&mut self, frame: &Frame) -> Result<(), Error> {
        let frame = outgoing(frame).ok_or_else(|| self.failed("send a frame", io::ErrorKind::InvalidInput.into()))?;
        let sent = self.socket.write_frame_insist(&frame);
        sent.map_err(|cause| self.failed("send a frame", cause))
    }

    fn receive(&mut self, patience: Duration) -> Result<Option<Frame>, Error> {
        // The system takes no time at all for no limit.
        let patience = patience.max(Duration::from_micros(1));
        match self.socket.read_frame_timeout(patience) {
            Ok(frame) => Ok(incoming(&frame)),
            Err(cause) if is_timeout(&cause) => Ok(None),
            Err(cause) => Err(self.failed("receive a frame", cause)),
        }
    }
}

fn is_timeout(cause: &io::Error) -> bool {
    use io::ErrorKind::{Interrupted, TimedOut, WouldBlock};
    matches!(cause.kind(), TimedOut | WouldBlock | Interrupted)
}

fn outgoing(frame: &Frame) -> Option<CanFrame> {
    if frame.is_remote_frame() {
        CanFrame::new_remote(EmbeddedFrame::id(frame), frame.dlc())
    } else {
        CanFrame::new(EmbeddedFrame::id(frame), EmbeddedFrame::data(frame))
    }
}

/// `None` for an error frame: it tells of the interface, and comes from no node.
fn incoming(frame: &CanFrame) -> Option<Frame> {
    match frame {
        CanFrame::Data(frame) => EmbeddedFrame::new(frame.id(), frame.data()),
        CanFrame::Remote(frame) => EmbeddedFrame::new_remote(frame.id(), frame.dlc()),
        CanFrame::Error(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use lexican_runtime::wire::CanId;

    use super::*;

    #[test]
    fn frames_of_every_kind_come_back_as_they_were() {
        let standard = CanId::standard(0x7FF).unwrap();
        let extended = CanId::extended(0x1FFF_FFFF).unwrap();
        let frames = [
            Frame::new(standard, &[]),
            Frame::new(extended, &[1, 2, 3, 4, 5, 6, 7, 8]),
            Frame::remote(standard, 1),
            Frame::remote(extended, 8),
        ];
        for frame in frames.map(Option::unwrap) {
            assert_eq!(incoming(&outgoing(&frame).unwrap()), Some(frame));
        }
    }

    #[test]
    fn an_interface_that_is_not_there_is_named() {
        let error = SocketCan::open("socketcan:nocan7".into(), "nocan7").err().unwrap();
        assert!(
            error.to_string().starts_with("socketcan:nocan7: cannot open: "),
            "{error}"
        );
    }
}
