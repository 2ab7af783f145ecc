//! A bus inside this process: what one sends reaches all others, in one order.

use std::{
    sync::{
        Arc, Mutex, MutexGuard, PoisonError,
        mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel},
    },
    time::Duration,
};

use lexican_runtime::wire::Frame;

/// How many frames wait for one who does not take them: two seconds of a full bus at 1 Mbit/s. What comes then is lost to it,
/// as with an adapter that nobody reads.
const ROOM: usize = 16_384;

/// A bus. Clones are the same one.
#[derive(Clone, Debug, Default)]
pub(super) struct Hub(Arc<Mutex<Seats>>);

#[derive(Debug, Default)]
struct Seats {
    all: Vec<Seat>,
    next: u64,
    is_closed: bool,
}

#[derive(Debug)]
struct Seat {
    number: u64,
    frames: SyncSender<Frame>,
}

/// One who is on the bus until it is dropped.
#[derive(Debug)]
pub(super) struct End {
    hub: Hub,
    number: u64,
    frames: Receiver<Frame>,
}

/// The bus is closed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Closed;

impl Hub {
    /// Joins the bus.
    pub(super) fn join(&self) -> End {
        let (sender, frames) = sync_channel(ROOM);
        let mut seats = self.seats();
        let number = seats.next;
        seats.next += 1;
        if !seats.is_closed {
            let seat = Seat { number, frames: sender };
            seats.all.push(seat);
        }
        let hub = self.clone();
        End { hub, number, frames }
    }

    /// Nobody gets a frame any more, and all who wait for one are told.
    pub(super) fn close(&self) {
        let mut seats = self.seats();
        seats.is_closed = true;
        seats.all.clear();
    }

    /// Whether [`Hub::close`] was called.
    pub(super) fn is_closed(&self) -> bool {
        self.seats().is_closed
    }

    /// How many are on the bus.
    #[cfg(test)]
    pub(super) fn len(&self) -> usize {
        self.seats().all.len()
    }

    /// Hands `frame` to all but `sender`.
    pub(super) fn send(&self, sender: u64, frame: Frame) {
        let seats = self.seats();
        for seat in seats.all.iter().filter(|seat| seat.number != sender) {
            // Full, or leaving just now: the frame is lost to it, and to nobody else.
            let _ = seat.frames.try_send(frame);
        }
    }

    /// The one of that number gets nothing any more, and is told if it waits.
    pub(super) fn leave(&self, number: u64) {
        self.seats().all.retain(|seat| seat.number != number);
    }

    /// No thread fails half way through a change.
    fn seats(&self) -> MutexGuard<'_, Seats> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl End {
    /// The number that [`Hub::send`] knows this one by.
    pub(super) fn number(&self) -> u64 {
        self.number
    }

    /// Hands `frame` to all others.
    pub(super) fn send(&self, frame: Frame) {
        self.hub.send(self.number, frame);
    }

    /// The next frame of another; `None` when none came within `patience`.
    pub(super) fn receive(&self, patience: Duration) -> Result<Option<Frame>, Closed> {
        match self.frames.recv_timeout(patience) {
            Ok(frame) => Ok(Some(frame)),
            Err(RecvTimeoutError::Timeout) => Ok(None),
            Err(RecvTimeoutError::Disconnected) => Err(Closed),
        }
    }

    /// The next frame of another, as long as it takes.
    pub(super) fn wait(&self) -> Result<Frame, Closed> {
        self.frames.recv().map_err(|_| Closed)
    }
}

impl Drop for End {
    fn drop(&mut self) {
        self.hub.leave(self.number);
    }
}

#[cfg(test)]
mod tests {
    use lexican_runtime::wire::CanId;

    use super::*;

    fn frame(byte: u8) -> Frame {
        Frame::byte(CanId::NMT, byte)
    }

    #[test]
    fn a_frame_reaches_all_others_and_not_its_sender() {
        let hub = Hub::default();
        let ends = [hub.join(), hub.join(), hub.join()];
        ends[0].send(frame(1));
        assert_eq!(ends[0].receive(Duration::ZERO).unwrap(), None);
        for end in &ends[1..] {
            assert_eq!(end.receive(Duration::ZERO).unwrap(), Some(frame(1)));
        }
    }

    #[test]
    fn who_takes_nothing_loses_the_newest_frames_and_holds_up_nobody() {
        let hub = Hub::default();
        let (sender, lazy) = (hub.join(), hub.join());
        for _ in 0..=ROOM {
            sender.send(frame(7));
        }
        let taken = std::iter::from_fn(|| lazy.receive(Duration::ZERO).unwrap()).count();
        assert_eq!(taken, ROOM);
    }

    #[test]
    fn who_left_is_forgotten_and_a_closed_bus_tells_those_who_wait() {
        let hub = Hub::default();
        drop(hub.join());
        let end = hub.join();
        assert_eq!(hub.len(), 1);
        hub.close();
        assert!(end.wait().is_err());
        assert!(hub.join().receive(Duration::from_secs(9)).is_err());
    }
}
