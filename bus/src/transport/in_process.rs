//! `virtual:name`: buses of this process, by name.

use std::{
    collections::HashMap,
    io,
    sync::{LazyLock, Mutex, PoisonError},
    time::Duration,
};

use lexican_runtime::wire::Frame;

use super::{
    Error, Transport,
    hub::{Closed, End, Hub},
};

/// A bus is there from the first who opens it to the end of the process; an empty one costs a few bytes.
static BUSES: LazyLock<Mutex<HashMap<String, Hub>>> = LazyLock::new(Mutex::default);

/// One who is on a bus of this process.
#[derive(Debug)]
pub(super) struct Virtual {
    name: String,
    end: End,
}

impl Virtual {
    /// Joins the bus `name`, which begins with this if nobody else is on it.
    pub(super) fn join(name: &str) -> Self {
        let mut buses = BUSES.lock().unwrap_or_else(PoisonError::into_inner);
        let hub = buses.entry(name.to_owned()).or_default();
        Self {
            name: name.to_owned(),
            end: hub.join(),
        }
    }
}

impl Transport for Virtual {
    fn send(&mut self, frame: &Frame) -> Result<(), Error> {
        self.end.send(*frame);
        Ok(())
    }

    fn receive(&mut self, patience: Duration) -> Result<Option<Frame>, Error> {
        self.end.receive(patience).map_err(|Closed| Error {
            bus: format!("virtual:{}", self.name),
            what: "receive",
            cause: io::ErrorKind::ConnectionAborted.into(),
        })
    }
}
