//! A CAN controller that is none, and a clock that goes as fast as it may.

use std::{collections::VecDeque, iter};

use lexican_runtime::{CanId, Frame, Instant};

/// What the master sends, and when, in ms.
const SCRIPT: [(u64, u32, &[u8]); 6] = [
    // Preset: the position is 1000.
    (5, 0x67F, &[0x23, 0x03, 0x60, 0x00, 0xE8, 0x03, 0x00, 0x00]),
    // Beyond the measuring range, which the handler refuses.
    (6, 0x67F, &[0x23, 0x03, 0x60, 0x00, 0xFF, 0xFF, 0xFF, 0xFF]),
    // A heartbeat every 25 ms.
    (7, 0x67F, &[0x2B, 0x17, 0x10, 0x00, 0x19, 0x00, 0x00, 0x00]),
    // OPERATIONAL: the shaft turns.
    (15, 0x000, &[0x01, 0x7F]),
    (42, 0x080, &[]),
    // STOPPED.
    (95, 0x000, &[0x02, 0x7F]),
];
/// When the example is over, in ms.
const END: u64 = 150;

/// The bus, with the master's frames still to come.
pub(crate) struct Can {
    to_come: VecDeque<(Instant, Frame)>,
}

impl Can {
    pub(crate) fn new() -> Self {
        let to_come = SCRIPT.iter().filter_map(|(millis, id, data)| {
            let frame = Frame::new(CanId::standard(*id)?, data)?;
            Some((Instant::from_millis(*millis), frame))
        });
        let to_come = to_come.collect();
        Self { to_come }
    }

    /// The next frame that has come in.
    pub(crate) fn receive(&mut self, now: Instant) -> Option<Frame> {
        let (at, frame) = *self.to_come.front()?;
        if at > now {
            return None;
        }
        self.to_come.pop_front();
        show(now, "master", &frame);
        Some(frame)
    }

    pub(crate) fn send(&mut self, now: Instant, frame: &Frame) {
        show(now, "device", frame);
    }

    /// Sleeps until `due` or the next frame, and says when it is; `None` at the end.
    pub(crate) fn sleep(&mut self, now: Instant, due: Instant) -> Option<Instant> {
        let frame = self.to_come.front().map(|(at, _)| *at);
        let awake = iter::once(due).chain(frame).min()?.max(now);
        (awake < Instant::from_millis(END)).then_some(awake)
    }
}

fn show(now: Instant, sender: &str, frame: &Frame) {
    println!("{:4} ms  {sender}  {frame:?}", now.as_micros() / 1000);
}
