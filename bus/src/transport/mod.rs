//! Ways to a CAN bus.
//!
//! [`open`] takes the name of a bus, as a user writes it behind `--bus`:
//!
//! | name | the bus |
//! |---|---|
//! | `slcan:/dev/ttyACM0@500k` | an adapter on a serial line; without a bit rate it keeps its own |
//! | `slcan+tcp://host:port` | the same lines over TCP |
//! | `slcan+tcp-listen://host:port` | a bus of our own that any number of others join by slcan over TCP |
//! | `socketcan:can0` | an interface of this Linux machine |
//! | `virtual:name` | a bus inside this process |

mod error;
mod hub;
mod in_process;
mod slcan;
#[cfg(target_os = "linux")]
mod socketcan;
mod url;

use std::{
    io::{self, ErrorKind},
    net::SocketAddr,
    time::Duration,
};

use lexican_runtime::wire::Frame;

pub use error::Error;
pub use url::{BitRate, FORMS, Url, UrlError};

use in_process::Virtual;
use slcan::{Listener, Serial, Slcan, Socket};
#[cfg(target_os = "linux")]
use socketcan::SocketCan;

/// Opens the bus that `name` names.
///
/// ```
/// use std::time::Duration;
/// use lexican_bus::transport::{Transport, open};
/// use lexican_runtime::wire::{CanId, Frame};
///
/// # fn main() -> Result<(), lexican_bus::transport::Error> {
/// let mut one = open("virtual:workshop")?;
/// let mut other = open("virtual:workshop")?;
/// one.send(&Frame::byte(CanId::NMT, 0x01))?;
/// assert_eq!(other.receive(Duration::from_secs(1))?, Some(Frame::byte(CanId::NMT, 0x01)));
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// When it is the name of no bus, or the bus is not there.
pub fn open(name: &str) -> Result<Box<dyn Transport>, Error> {
    let url: Url = name
        .parse()
        .map_err(|error: UrlError| unopened(name, ErrorKind::InvalidInput, error))?;
    url.open()
}

impl Url {
    /// Opens the bus.
    ///
    /// # Errors
    /// When it is not there.
    pub fn open(&self) -> Result<Box<dyn Transport>, Error> {
        let name = self.to_string();
        match self {
            Self::SlcanTcp { address, bit_rate } => {
                let socket = Socket::connect(address).map_err(|cause| unopened(&name, cause.kind(), cause))?;
                Ok(Box::new(Slcan::open(name, socket, *bit_rate)?))
            }
            Self::Slcan { device, bit_rate } => {
                let serial = Serial::open(device).map_err(|cause| unopened(&name, cause.kind(), cause))?;
                Ok(Box::new(Slcan::open(name, serial, *bit_rate)?))
            }
            Self::SlcanTcpListen { address } => Ok(Box::new(Listener::bind(name, address)?)),
            Self::Virtual { name } => Ok(Box::new(Virtual::join(name))),
            #[cfg(target_os = "linux")]
            Self::SocketCan { interface } => Ok(Box::new(SocketCan::open(name, interface)?)),
            #[cfg(not(target_os = "linux"))]
            Self::SocketCan { .. } => Err(unopened(
                &name,
                ErrorKind::Unsupported,
                "only Linux has such interfaces",
            )),
            Self::Socketcand { .. } => Err(unopened(
                &name,
                ErrorKind::Unsupported,
                "this kind of bus is not built yet",
            )),
        }
    }
}

fn unopened(bus: &str, kind: ErrorKind, cause: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> Error {
    Error {
        bus: bus.to_owned(),
        what: "open",
        cause: io::Error::new(kind, cause),
    }
}

/// A way to a bus: frames out, frames in.
///
/// What has been sent does not come back, and every frame of another is received once, in the order of the bus.
pub trait Transport: Send {
    /// Hands `frame` to the bus.
    ///
    /// # Errors
    /// When the bus is gone or does not take it. What can be tried again has been tried.
    fn send(&mut self, frame: &Frame) -> Result<(), Error>;

    /// The next frame from the bus; `None` when none came within `patience`. With no patience at all it looks, and does not wait.
    ///
    /// Lines and bytes that are no frame are passed over.
    ///
    /// # Errors
    /// When the bus is gone: none will come any more.
    fn receive(&mut self, patience: Duration) -> Result<Option<Frame>, Error>;

    /// Where others join, when this is a listener.
    fn address(&self) -> Option<SocketAddr> {
        None
    }
}

impl<T: Transport + ?Sized> Transport for Box<T> {
    fn send(&mut self, frame: &Frame) -> Result<(), Error> {
        (**self).send(frame)
    }

    fn receive(&mut self, patience: Duration) -> Result<Option<Frame>, Error> {
        (**self).receive(patience)
    }
    fn address(&self) -> Option<SocketAddr> {
        (**self).address()
    }
}
