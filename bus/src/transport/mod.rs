//! Ways to a CAN bus.

mod error;

use std::time::Duration;

use lexican_runtime::wire::Frame;

pub use error::Error;

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
}

impl<T: Transport + ?Sized> Transport for Box<T> {
    fn send(&mut self, frame: &Frame) -> Result<(), Error> {
        (**self).send(frame)
    }

    fn receive(&mut self, patience: Duration) -> Result<Option<Frame>, Error> {
        (**self).receive(patience)
    }
}
