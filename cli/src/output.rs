//! Standard output, whose reader may leave.

use std::io::{self, BufWriter, ErrorKind, Write};

use anstream::AutoStream;

use crate::failure::Failure;

/// Standard output. That its reader leaves, as in `lexican … | head`, is no error.
pub(crate) struct Stdout(BufWriter<Box<dyn Write>>);

impl Stdout {
    /// For people: escape sequences get through where they are wanted.
    pub(crate) fn styled() -> Self {
        Self(BufWriter::new(Box::new(AutoStream::auto(io::stdout()).lock())))
    }

    /// For programs: everything gets through as it is.
    pub(crate) fn plain() -> Self {
        Self(BufWriter::new(Box::new(io::stdout().lock())))
    }

    /// Writes `text`, and all that is still held back.
    pub(crate) fn print(mut self, text: &str) -> Result<(), Failure> {
        self.write_all(text.as_bytes()).map_err(|error| unwritten(&error))?;
        self.finish()
    }

    /// Writes what is still held back.
    pub(crate) fn finish(mut self) -> Result<(), Failure> {
        self.flush().map_err(|error| unwritten(&error))
    }
}

impl Write for Stdout {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        unless_gone(self.0.write(bytes), bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        unless_gone(self.0.flush(), ())
    }
}

/// A reader that left has seen what it wanted.
fn unless_gone<T>(result: io::Result<T>, done: T) -> io::Result<T> {
    match result {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(done),
        result => result,
    }
}

pub(crate) fn unwritten(error: &io::Error) -> Failure {
    Failure::io("cannot write to", "standard output", error)
}
