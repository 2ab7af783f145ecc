//! A bus with one node on it, spoken to in lines:
//!
//! ```
//! use lexican_tests::{bus::Bus, sample};
//!
//! Bus::booted(sample::quiet(), 1)
//!     .send("601#4000100000000000")
//!     .expect("581#4300100096010200")
//!     .silence();
//! ```

use std::{collections::VecDeque, marker::PhantomData};

use lexican_runtime::{AbortCode, Address, Device, Frame, Instant, Node, NodeId, od};

use crate::line;

/// What a bus is spoken to: a node, or a device around one.
pub trait Slave<D: Device> {
    /// Takes a frame from the bus.
    fn receive(&mut self, now: Instant, frame: &Frame);
    /// The next frame to send.
    fn poll(&mut self, now: Instant) -> Option<Frame>;
    /// When it is to be polled next.
    fn poll_at(&self) -> Option<Instant>;
    /// The node in it.
    fn node(&mut self) -> &mut Node<D>;
    /// Lets the application have this value, as on the bus.
    ///
    /// # Errors
    /// The abort code of [`od::set`].
    fn set(&mut self, address: Address, data: &[u8]) -> Result<(), AbortCode> {
        od::set(self.node().device_mut(), address, data)
    }
}

impl<D: Device> Slave<D> for Node<D> {
    fn receive(&mut self, now: Instant, frame: &Frame) {
        Node::receive(self, now, frame);
    }

    fn poll(&mut self, now: Instant) -> Option<Frame> {
        Node::poll(self, now)
    }

    fn poll_at(&self) -> Option<Instant> {
        Node::poll_at(self)
    }

    fn node(&mut self) -> &mut Node<D> {
        self
    }
}

/// A node, a clock, and what the node has sent.
pub struct Bus<D: Device, S = Node<D>> {
    slave: S,
    device: PhantomData<D>,
    now: Instant,
    sent: VecDeque<Frame>,
    /// The dialogue so far, shown when it goes wrong.
    log: Vec<String>,
}

impl<D: Device> Bus<D> {
    /// A bus with `device` on it, just switched on: it has said nothing yet.
    ///
    /// # Panics
    /// When `node_id` is not 1 to 127.
    #[must_use]
    pub fn new(device: D, node_id: u8) -> Self {
        let node_id = NodeId::new(node_id).expect("a node-ID, 1 to 127");
        Self::of(Node::new(device, node_id))
    }

    /// A bus with `node` on it, which has said nothing yet.
    #[must_use]
    pub fn of(node: Node<D>) -> Self {
        Self::with(node)
    }

    /// A bus with `device` on it, which has sent its boot-up message.
    ///
    /// # Panics
    /// When it sends something else.
    #[must_use]
    #[track_caller]
    pub fn booted(device: D, node_id: u8) -> Self {
        let mut bus = Self::new(device, node_id);
        bus.advance(0).expect(&format!("{:03X}#00", 0x700 + u16::from(node_id)));
        bus
    }
}

impl<D: Device, S: Slave<D>> Bus<D, S> {
    /// A bus with `slave` on it, which has said nothing yet.
    #[must_use]
    pub fn with(slave: S) -> Self {
        Self {
            slave,
            device: PhantomData,
            now: Instant::from_millis(1),
            sent: VecDeque::new(),
            log: Vec::new(),
        }
    }

    /// Sends a frame to the node, and takes what it answers at once.
    #[track_caller]
    pub fn send(&mut self, frame: &str) -> &mut Self {
        self.put(line::frame(frame))
    }

    /// As [`Bus::send`], of a frame that is none of text.
    pub fn put(&mut self, frame: Frame) -> &mut Self {
        self.log.push(format!("> {frame:?}"));
        self.slave.receive(self.now, &frame);
        self.collect();
        self
    }

    /// The next frame that the node has sent, in the order of sending. `581#43..` is any frame that begins so.
    ///
    /// # Panics
    /// When it is another one, or there is none.
    #[track_caller]
    pub fn expect(&mut self, frame: &str) -> &mut Self {
        let sent = self
            .take()
            .map_or_else(|| "nothing".to_owned(), |sent| format!("{sent:?}"));
        let right = match frame.strip_suffix("..") {
            Some(beginning) => sent.starts_with(beginning),
            None => sent == format!("{:?}", line::frame(frame)),
        };
        assert!(right, "expected {frame}, got {sent}, after\n{}", self.log.join("\n"));
        self
    }

    /// The node has sent nothing more.
    ///
    /// # Panics
    /// When it has.
    #[track_caller]
    pub fn silence(&mut self) -> &mut Self {
        if let Some(sent) = self.take() {
            panic!("expected silence, got {sent:?}, after\n{}", self.log.join("\n"));
        }
        self
    }

    /// Lets `millis` ms pass, the node being polled when it asks for it.
    pub fn advance(&mut self, millis: u64) -> &mut Self {
        let end = Instant::from_micros(self.now.as_micros() + millis * 1000);
        self.log.push(format!("+ {millis} ms"));
        self.collect();
        while let Some(due) = self.slave.poll_at().filter(|due| *due <= end) {
            self.now = due.max(self.now);
            self.collect();
        }
        self.now = end;
        self
    }

    /// The next frame that the node has sent.
    pub fn take(&mut self) -> Option<Frame> {
        self.sent.pop_front()
    }

    /// The node.
    pub fn node(&mut self) -> &mut Node<D> {
        self.slave.node()
    }

    /// What is on the bus.
    pub fn slave(&mut self) -> &mut S {
        &mut self.slave
    }

    /// The time on this bus.
    #[must_use]
    pub fn now(&self) -> Instant {
        self.now
    }

    /// Takes all that the node has to say now.
    fn collect(&mut self) {
        while let Some(frame) = self.slave.poll(self.now) {
            self.log.push(format!("< {frame:?}"));
            self.sent.push_back(frame);
        }
        let due = self.slave.poll_at();
        assert!(
            due.is_none_or(|due| due > self.now),
            "it has nothing to say, and asks to be called at once"
        );
    }
}
