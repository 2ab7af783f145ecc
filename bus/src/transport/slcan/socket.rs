//! A TCP connection as the stream of an slcan line.

use std::{
    io::{self, Read, Write},
    net::{TcpStream, ToSocketAddrs},
    time::Duration,
};

use super::Stream;

/// How long connecting may take for each address that a host has.
const CONNECT: Duration = Duration::from_secs(5);

/// How long the other side may take nothing before it counts as gone.
pub(super) const STALLED: Duration = Duration::from_secs(5);

/// A TCP connection.
#[derive(Debug)]
pub(in crate::transport) struct Socket {
    stream: TcpStream,
    /// The patience that the system has been told.
    patience: Option<Duration>,
}

impl Socket {
    /// Connects to `host:port`: the first of its addresses that answers.
    pub(in crate::transport) fn connect(address: &str) -> io::Result<Self> {
        let mut failure = io::Error::new(io::ErrorKind::NotFound, "the host has no address");
        for address in address.to_socket_addrs()? {
            match TcpStream::connect_timeout(&address, CONNECT) {
                Ok(stream) => return Self::of(stream),
                Err(error) => failure = error,
            }
        }
        Err(failure)
    }

    fn of(stream: TcpStream) -> io::Result<Self> {
        stream.set_nodelay(true)?;
        stream.set_write_timeout(Some(STALLED))?;
        Ok(Self { stream, patience: None })
    }
}

impl Stream for Socket {
    fn set_patience(&mut self, patience: Duration) -> io::Result<()> {
        if self.patience == Some(patience) {
            return Ok(());
        }
        self.stream.set_nonblocking(patience.is_zero())?;
        if !patience.is_zero() {
            self.stream.set_read_timeout(Some(patience))?;
        }
        self.patience = Some(patience);
        Ok(())
    }
}

impl Read for Socket {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.stream.read(buffer)
    }
}

impl Write for Socket {
    fn write(&mut self, buffer: &[u8]) -> io::Result<usize> {
        if self.patience == Some(Duration::ZERO) {
            self.stream.set_nonblocking(false)?;
            self.patience = None;
        }
        self.stream.write(buffer)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.stream.flush()
    }
}
