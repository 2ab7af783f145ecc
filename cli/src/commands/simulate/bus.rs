//! The loop between the devices and the bus.

use std::{
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
    time::{Duration, Instant},
};

use lexican_bus::transport::{self, Transport};
use lexican_runtime::{Frame, Instant as Micros};

use super::{
    nodes::Nodes,
    record::Record,
    script::{Next, Script},
};
use crate::failure::{self, Failure};

/// How long it takes at most to see that the user wants to end.
const PATIENCE: Duration = Duration::from_millis(50);

/// How many frames are taken before the devices are asked again: more only wait when they come faster than they are served.
const AT_ONCE: usize = 64;

/// Serves the devices on the bus of that name until the user or the script ends it, or the bus is gone.
pub(super) fn serve(name: &str, nodes: Nodes, script: Script, record: Option<Record>) -> Result<(), Failure> {
    let is_over = end_by_signal()?;
    let transport = transport::open(name).map_err(|error| lost(&error))?;
    nodes.announce();
    announce(name, &*transport);
    let mut bus = Bus {
        transport,
        nodes,
        script,
        record,
        start: Instant::now(),
    };
    while !is_over.load(Ordering::Relaxed) {
        if bus.turn()? == Next::Quit {
            break;
        }
    }
    Ok(())
}

fn lost(error: &transport::Error) -> Failure {
    Failure::new(error.to_string())
}

/// Ctrl-C, and being asked to end, end the loop and not the process: what is recorded gets written.
fn end_by_signal() -> Result<Arc<AtomicBool>, Failure> {
    let is_over = Arc::new(AtomicBool::new(false));
    let signal = Arc::clone(&is_over);
    ctrlc::set_handler(move || signal.store(true, Ordering::Relaxed))
        .map_err(|error| Failure::new(format!("cannot be told of Ctrl-C: {error}")))?;
    Ok(is_over)
}

fn announce(name: &str, transport: &dyn Transport) {
    failure::note(&match transport.address() {
        Some(address) => format!(
            "serving on port {}; join by --bus slcan+tcp://{address}",
            address.port()
        ),
        None => format!("serving on {name}"),
    });
}

struct Bus {
    transport: Box<dyn Transport>,
    nodes: Nodes,
    script: Script,
    record: Option<Record>,
    start: Instant,
}

impl Bus {
    /// Does what is due, sends what there is to say, and waits for what comes. Says [`Next::Quit`] at the end of the script.
    fn turn(&mut self) -> Result<Next, Failure> {
        let now = Instant::now();
        let next = self.script.next(now);
        if let Next::Assign(assignment) = &next
            && let Err(reason) = self.nodes.assign(assignment)
        {
            self.script.complain(&reason);
        }
        self.send()?;
        let patience = match next {
            Next::Nothing => self.patience(now),
            // There may be more to do at once.
            Next::Assign(_) | Next::Quit => Duration::ZERO,
        };
        self.receive(patience)?;
        Ok(next)
    }

    /// Sends all that the devices have to say now.
    fn send(&mut self) -> Result<(), Failure> {
        let now = self.clock();
        while let Some(frame) = self.nodes.network.poll(now) {
            self.transport.send(&frame).map_err(|error| lost(&error))?;
            self.keep(&frame)?;
        }
        self.record.as_mut().map_or(Ok(()), Record::flush)
    }

    /// Waits for a frame, and takes those that have come with it.
    fn receive(&mut self, patience: Duration) -> Result<(), Failure> {
        let mut patience = patience;
        for _ in 0..AT_ONCE {
            let frame = self.transport.receive(patience).map_err(|error| lost(&error))?;
            let Some(frame) = frame else { return Ok(()) };
            self.keep(&frame)?;
            self.nodes.network.receive(self.clock(), &frame);
            self.send()?;
            patience = Duration::ZERO;
        }
        Ok(())
    }

    fn keep(&mut self, frame: &Frame) -> Result<(), Failure> {
        self.record.as_mut().map_or(Ok(()), |record| record.frame(frame))
    }

    /// Until a device or the script has something to do.
    fn patience(&self, now: Instant) -> Duration {
        let due = self.nodes.network.poll_at().map_or(PATIENCE, |due| {
            Duration::from_micros(due.as_micros().saturating_sub(self.clock().as_micros()))
        });
        let script = self.script.patience(now).unwrap_or(PATIENCE);
        due.min(script).min(PATIENCE)
    }

    fn clock(&self) -> Micros {
        Micros::from_micros(u64::try_from(self.start.elapsed().as_micros()).unwrap_or(u64::MAX))
    }
}
