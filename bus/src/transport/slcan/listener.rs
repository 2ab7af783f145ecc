//! A bus of our own that others join by TCP: to each of them we are an slcan adapter.

use std::{
    io::{self, ErrorKind, Read, Write},
    net::{IpAddr, Ipv4Addr, Ipv6Addr, Shutdown, SocketAddr, TcpListener, TcpStream},
    sync::{
        Arc, Mutex, PoisonError,
        atomic::{AtomicBool, Ordering},
    },
    thread::{self, JoinHandle},
    time::Duration,
};

use lexican_runtime::wire::{
    Frame,
    slcan::{Answer, Command, Lines},
};

use super::{Error, Transport, socket::STALLED};
use crate::transport::hub::{Closed, End, Hub};

/// A listener; its own end of the bus is the transport.
///
/// A client is on the bus from its first moment, so that one that only looks on need say nothing; `C` takes it off and `O` puts
/// it back. Bit rates are taken and mean nothing.
#[derive(Debug)]
pub(in crate::transport) struct Listener {
    bus: String,
    address: SocketAddr,
    hub: Hub,
    end: End,
    doors: Option<JoinHandle<()>>,
}

impl Listener {
    /// Listens on `host:port`; with port 0 on any that is free, which [`Transport::address`] then says.
    pub(in crate::transport) fn bind(bus: String, address: &str) -> Result<Self, Error> {
        let hub = Hub::default();
        let listening = TcpListener::bind(address).and_then(|listener| {
            let address = listener.local_addr()?;
            let bus = hub.clone();
            Ok((address, spawn("slcan listener", move || accept(&listener, &bus))?))
        });
        match listening {
            Ok((address, doors)) => Ok(Self {
                bus,
                address,
                end: hub.join(),
                hub,
                doors: Some(doors),
            }),
            Err(cause) => Err(Error {
                bus,
                what: "listen",
                cause,
            }),
        }
    }

    /// An address at which this machine reaches the listener.
    fn own_address(&self) -> SocketAddr {
        let ip = match self.address.ip() {
            IpAddr::V4(ip) if ip.is_unspecified() => IpAddr::V4(Ipv4Addr::LOCALHOST),
            IpAddr::V6(ip) if ip.is_unspecified() => IpAddr::V6(Ipv6Addr::LOCALHOST),
            ip => ip,
        };
        SocketAddr::new(ip, self.address.port())
    }
}

impl Transport for Listener {
    fn send(&mut self, frame: &Frame) -> Result<(), Error> {
        self.end.send(*frame);
        Ok(())
    }

    fn receive(&mut self, patience: Duration) -> Result<Option<Frame>, Error> {
        self.end.receive(patience).map_err(|Closed| Error {
            bus: self.bus.clone(),
            what: "receive",
            cause: ErrorKind::ConnectionAborted.into(),
        })
    }

    fn address(&self) -> Option<SocketAddr> {
        Some(self.address)
    }
}

impl Drop for Listener {
    /// All clients are left, and the thread that waits for more is woken to see that there will be none.
    fn drop(&mut self) {
        self.hub.close();
        let is_woken = TcpStream::connect_timeout(&self.own_address(), Duration::from_secs(1)).is_ok();
        if let Some(doors) = self.doors.take().filter(|_| is_woken) {
            // When it is over, the port is free.
            let _ = doors.join();
        }
    }
}

fn spawn(name: &str, work: impl FnOnce() + Send + 'static) -> io::Result<JoinHandle<()>> {
    thread::Builder::new().name(name.to_owned()).spawn(work)
}

/// Lets clients in until the bus is closed.
fn accept(listener: &TcpListener, hub: &Hub) {
    for stream in listener.incoming() {
        if hub.is_closed() {
            return;
        }
        match stream {
            // A client that cannot be served is let go; the others are not to suffer.
            Ok(stream) => drop(Client::serve(stream, hub)),
            // No more files for now, or a client that was gone before it was let in.
            Err(_) => thread::sleep(Duration::from_millis(10)),
        }
    }
}

/// One who has joined by TCP. Two threads serve it: one takes its lines, one hands it the frames of the bus.
struct Client {
    stream: TcpStream,
    /// Answers and frames are not to get mixed.
    out: Mutex<TcpStream>,
    is_on_bus: AtomicBool,
}

impl Client {
    fn serve(stream: TcpStream, hub: &Hub) -> io::Result<()> {
        stream.set_nodelay(true)?;
        stream.set_write_timeout(Some(STALLED))?;
        let client = Arc::new(Self {
            out: Mutex::new(stream.try_clone()?),
            stream,
            is_on_bus: AtomicBool::new(true),
        });
        let end = hub.join();
        let (reader, hub, number) = (Arc::clone(&client), hub.clone(), end.number());
        spawn("slcan client, lines", move || {
            let _ = reader.take_lines(|frame| hub.send(number, frame));
            reader.leave();
            hub.leave(number);
        })?;
        spawn("slcan client, frames", move || {
            client.hand_frames(&end);
            client.leave();
        })?;
        Ok(())
    }

    /// Ends what the other thread waits for.
    fn leave(&self) {
        let _ = self.stream.shutdown(Shutdown::Both);
    }

    /// Hands it each frame of the bus, as many in one write as there are.
    fn hand_frames(&self, end: &End) {
        let mut text = Vec::new();
        while let Ok(frame) = end.wait() {
            text.clear();
            let rest = std::iter::from_fn(|| end.receive(Duration::ZERO).ok().flatten());
            for frame in std::iter::once(frame).chain(rest).take(128) {
                let timestamp = None;
                text.extend(Answer::Received { frame, timestamp }.emit().as_bytes());
            }
            if self.is_on_bus.load(Ordering::Relaxed) && self.write(&text).is_err() {
                return;
            }
        }
    }

    /// Obeys its lines until it leaves; `send` is for frames.
    fn take_lines(&self, send: impl Fn(Frame)) -> io::Result<()> {
        let mut lines = Lines::new();
        let mut bytes = [0; 4096];
        let mut answers = Vec::new();
        loop {
            let length = (&self.stream).read(&mut bytes)?;
            let read = bytes.get(..length).filter(|read| !read.is_empty());
            let Some(read) = read else { return Ok(()) };
            answers.clear();
            for line in read.iter().filter_map(|byte| lines.push(*byte)) {
                answers.extend(self.obey(Command::parse(line.as_bytes()), &send).emit().as_bytes());
            }
            self.write(&answers)?;
        }
    }

    fn obey(&self, command: Option<Command>, send: impl Fn(Frame)) -> Answer {
        match command {
            Some(Command::Transmit(frame)) if self.is_on_bus.load(Ordering::Relaxed) => {
                send(frame);
                let extended = frame.id().is_extended();
                Answer::Sent { extended }
            }
            Some(Command::Open | Command::Listen) => self.go(true),
            Some(Command::Close) => self.go(false),
            Some(Command::Status) => Answer::Status(0),
            Some(Command::Version) => Answer::Version {
                hardware: 0x01,
                software: 0x01,
            },
            Some(Command::SerialNumber) => Answer::SerialNumber(*b"LEXI"),
            Some(Command::Transmit(_) | Command::Timestamps(true)) | None => Answer::Refused,
            Some(_) => Answer::Done,
        }
    }

    fn go(&self, on_bus: bool) -> Answer {
        self.is_on_bus.store(on_bus, Ordering::Relaxed);
        Answer::Done
    }

    fn write(&self, text: &[u8]) -> io::Result<()> {
        let mut out = self.out.lock().unwrap_or_else(PoisonError::into_inner);
        out.write_all(text)
    }
}
