//! A log of the bus, as `candump -l` writes it.

use std::{
    fs::File,
    io::{self, BufWriter},
    path::{Path, PathBuf},
    time::{SystemTime, UNIX_EPOCH},
};

use lexican_bus::log::Writer;
use lexican_runtime::{Frame, Instant};

use crate::failure::Failure;

/// The log that is being written.
pub(super) struct Record {
    path: PathBuf,
    log: Writer<BufWriter<File>>,
}

impl Record {
    /// A log that begins now.
    pub(super) fn create(path: &Path) -> Result<Self, Failure> {
        let file =
            File::create(path).map_err(|error| Failure::io("cannot write", &path.display().to_string(), &error))?;
        Ok(Self {
            path: path.to_owned(),
            log: Writer::new(BufWriter::new(file), "can0"),
        })
    }

    /// Adds a frame, which is on the bus now.
    pub(super) fn frame(&mut self, frame: &Frame) -> Result<(), Failure> {
        let time = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        let time = Instant::from_micros(u64::try_from(time.as_micros()).unwrap_or(u64::MAX));
        let written = self.log.write(time, frame);
        written.map_err(|error| self.failure(&error))
    }

    /// Writes what is still held back, so that whoever reads the log, or ends this process, has it.
    pub(super) fn flush(&mut self) -> Result<(), Failure> {
        self.log.flush().map_err(|error| self.failure(&error))
    }

    fn failure(&self, error: &io::Error) -> Failure {
        Failure::io("cannot write", &self.path.display().to_string(), error)
    }
}
