//! A serial device as the stream of an slcan line.

use std::{
    io::{self, Read, Write},
    time::Duration,
};

use serial2::SerialPort;

use super::{Stream, socket::STALLED};

/// The speed of the line, which adapters on USB do not care for.
const BAUD: u32 = 115_200;

/// A serial device, or a pseudo terminal.
#[derive(Debug)]
pub(in crate::transport) struct Serial(SerialPort);

impl Serial {
    /// Opens the device: 115,200 baud, 8 bits, no parity, bytes as they are.
    pub(in crate::transport) fn open(device: &str) -> io::Result<Self> {
        let mut port = SerialPort::open(device, BAUD)?;
        port.set_write_timeout(STALLED)?;
        Ok(Self(port))
    }
}

impl Stream for Serial {
    fn set_patience(&mut self, patience: Duration) -> io::Result<()> {
        self.0.set_read_timeout(patience)
    }
}

impl Read for Serial {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.0.read(buffer)
    }
}

impl Write for Serial {
    fn write(&mut self, buffer: &[u8]) -> io::Result<usize> {
        self.0.write(buffer)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
