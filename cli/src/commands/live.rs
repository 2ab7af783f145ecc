//! Devices on a bus: how they are reached, and what is read of one.

use std::{
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
    time::Duration,
};

use clap::Args;
use lexican_bus::{
    dump::{Order, Reader},
    sdo::Patience,
    transport::{self, Transport},
};
use lexican_eds::{dump::Dump, ir::NodeId};

use crate::{failure::Failure, progress::Progress};

/// How devices are reached.
#[derive(Args, Clone)]
pub(crate) struct LiveArguments {
    /// How long to wait for each answer, in milliseconds; a value is asked for twice
    #[arg(long, value_name = "MS", default_value_t = 500, value_parser = clap::value_parser!(u64).range(1..=60_000))]
    timeout: u64,
}

/// A bus with devices on it, and the user who may have seen enough.
pub(crate) struct Live {
    transport: Box<dyn Transport>,
    patience: Patience,
    stopped: Arc<AtomicBool>,
}

/// What was read of a device.
pub(crate) struct Taken {
    pub(crate) dump: Dump,
    pub(crate) end: End,
}

/// Why no more was read.
pub(crate) enum End {
    /// That was all.
    Whole,
    /// The user stopped it: so many steps of so many were done.
    Stopped(usize, usize),
    /// The bus or the device is gone, or was not there.
    Failed(lexican_bus::dump::Error),
}

impl LiveArguments {
    /// Opens `bus`. From here on Ctrl-C is a wish, not an end.
    pub(crate) fn open(&self, bus: &str) -> Result<Live, Failure> {
        let transport = transport::open(bus).map_err(|error| Failure::new(error.to_string()))?;
        let stopped = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&stopped);
        ctrlc::set_handler(move || flag.store(true, Ordering::Relaxed))
            .map_err(|error| Failure::new(format!("cannot listen for Ctrl-C: {error}")))?;
        Ok(Live {
            transport,
            patience: Patience {
                timeout: Duration::from_millis(self.timeout),
                ..Patience::default()
            },
            stopped,
        })
    }
}

impl Live {
    /// Reads what of `order` is not in `begun` yet. A bar shows how far it is, if `shown`.
    pub(crate) fn take(&mut self, begun: Dump, order: Order, shown: bool) -> Taken {
        let node_id = begun.node_id.get();
        let mut reader = Reader::new(begun, order, self.patience);
        let mut progress = Progress::reading(node_id, reader.total(), shown);
        let end = self.read(&mut reader, &mut progress);
        let dump = reader.into_dump();
        Taken { dump, end }
    }

    /// Whether the user has had enough.
    pub(crate) fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Relaxed)
    }

    fn read(&mut self, reader: &mut Reader, progress: &mut Progress) -> End {
        if let Err(error) = reader.identify(&mut self.transport) {
            return End::Failed(error);
        }
        while !self.is_stopped() {
            match reader.step(&mut self.transport) {
                Ok(Some(_)) => progress.reach(reader.done()),
                Ok(None) => return End::Whole,
                Err(error) => return End::Failed(error),
            }
        }
        End::Stopped(reader.done(), reader.total())
    }
}

/// `5` as a node-ID; for clap.
pub(crate) fn node_id(text: &str) -> Result<NodeId, String> {
    let node_id = text.parse().ok().and_then(NodeId::new);
    node_id.ok_or_else(|| "a node-ID is a number from 1 to 127".into())
}
