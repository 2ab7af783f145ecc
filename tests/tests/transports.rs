//! What goes in at one end of a bus comes out at the others.

#![expect(clippy::unwrap_used, reason = "a test that cannot be set up has failed")]

use std::{
    io::{Read, Write},
    net::{SocketAddr, TcpListener, TcpStream},
    thread,
    time::{Duration, Instant},
};

use lexican_bus::transport::{Transport, open};
use lexican_runtime::Frame;
use lexican_tests::line;

/// Long enough for any machine; a test that works does not wait for it.
const LONG: Duration = Duration::from_secs(20);

/// A bus that listens, and where.
fn listener() -> (Box<dyn Transport>, SocketAddr) {
    let listener = open("slcan+tcp-listen://127.0.0.1:0").unwrap();
    let address = listener.address().expect("a listener has an address");
    (listener, address)
}

/// A client of the listener, which knows of it.
fn client(listener: &mut dyn Transport, address: SocketAddr) -> Box<dyn Transport> {
    let mut client = open(&format!("slcan+tcp://{address}@500k")).unwrap();
    let hello = line::frame("7FF#01");
    client.send(&hello).unwrap();
    assert_eq!(listener.receive(LONG).unwrap(), Some(hello));
    client
}

fn expect(bus: &mut dyn Transport, frame: &str) {
    let received = bus.receive(LONG).unwrap();
    assert_eq!(received, Some(line::frame(frame)));
}

fn silent(bus: &mut dyn Transport) {
    assert_eq!(bus.receive(Duration::ZERO).unwrap(), None);
}

/// A connection that has said nothing.
fn raw(address: SocketAddr) -> TcpStream {
    let stream = TcpStream::connect(address).unwrap();
    stream.set_read_timeout(Some(LONG)).unwrap();
    stream
}

#[track_caller]
fn read(stream: &mut TcpStream, expected: &str) {
    let mut text = vec![0; expected.len()];
    stream.read_exact(&mut text).unwrap();
    assert_eq!(
        text.escape_ascii().to_string(),
        expected.as_bytes().escape_ascii().to_string()
    );
}

#[test]
fn a_frame_of_one_client_reaches_the_listener_and_all_other_clients() {
    let (mut listener, address) = listener();
    let mut one = client(&mut listener, address);
    let mut two = client(&mut listener, address);
    expect(&mut one, "7FF#01");
    for frame in ["601#4000100000000000", "1ABCDEF0#0102", "000#", "705#R1"] {
        let sent = if frame == "705#R1" {
            Frame::remote(line::frame("705#").id(), 1).unwrap()
        } else {
            line::frame(frame)
        };
        one.send(&sent).unwrap();
        assert_eq!(two.receive(LONG).unwrap(), Some(sent));
        assert_eq!(listener.receive(LONG).unwrap(), Some(sent));
        silent(&mut one);
    }
    listener.send(&line::frame("701#05")).unwrap();
    expect(&mut one, "701#05");
    expect(&mut two, "701#05");
    silent(&mut listener);
}

#[test]
fn a_client_that_leaves_is_missed_by_nobody() {
    let (mut listener, address) = listener();
    let mut one = client(&mut listener, address);
    drop(client(&mut listener, address));
    expect(&mut one, "7FF#01");
    one.send(&line::frame("080#")).unwrap();
    expect(&mut listener, "080#");
}

#[test]
fn a_thousand_frames_come_in_their_order() {
    let (mut listener, address) = listener();
    let mut one = client(&mut listener, address);
    for number in 0..1000_u32 {
        let frame = line::frame(&format!("123#{number:08X}"));
        one.send(&frame).unwrap();
        listener.send(&frame).unwrap();
    }
    for number in 0..1000_u32 {
        let frame = format!("123#{number:08X}");
        expect(&mut listener, &frame);
        expect(&mut one, &frame);
    }
}

#[test]
fn a_listener_answers_as_an_adapter_does() {
    let (mut listener, address) = listener();
    let mut host = raw(address);
    host.write_all(b"\rC\rS6\rO\rV\rN\rF\rx\rt12\r\x07T000001231FF\rt7011")
        .unwrap();
    read(&mut host, "\r\r\r\rV0101\rNLEXI\rF00\r\x07\x07\x07Z\r");
    expect(&mut listener, "00000123#FF");
    host.write_all(b"05\r").unwrap();
    read(&mut host, "z\r");
    expect(&mut listener, "701#05");
    listener.send(&line::frame("581#60")).unwrap();
    read(&mut host, "t581160\r");
}

#[test]
fn a_closed_client_neither_hears_nor_sends() {
    let (mut listener, address) = listener();
    let mut host = raw(address);
    host.write_all(b"C\rt12300\r").unwrap();
    read(&mut host, "\r\x07");
    silent(&mut listener);
    listener.send(&line::frame("581#60")).unwrap();
    // The frame is handed over, and kept from the client, by a thread of its own.
    thread::sleep(Duration::from_millis(50));
    host.write_all(b"O\rt1230\r").unwrap();
    read(&mut host, "\rz\r");
    expect(&mut listener, "123#");
}

#[test]
fn garbage_is_passed_over_by_both_sides() {
    let (mut listener, address) = listener();
    let mut host = raw(address);
    host.write_all(&[0xFF; 10_000]).unwrap();
    host.write_all(b"\rt1230\r").unwrap();
    expect(&mut listener, "123#");

    let server = TcpListener::bind("127.0.0.1:0").unwrap();
    let mut bus = open(&format!("slcan+tcp://{}", server.local_addr().unwrap())).unwrap();
    let (mut adapter, _) = server.accept().unwrap();
    adapter.write_all(b"\x00\xFFhello\rt9999\r\r\rt1231AB\r").unwrap();
    expect(&mut bus, "123#AB");
}

#[test]
fn a_client_says_what_an_adapter_has_to_hear_first() {
    let server = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = server.local_addr().unwrap();
    let _with_rate = open(&format!("slcan+tcp://{address}@250k")).unwrap();
    let (mut adapter, _) = server.accept().unwrap();
    read(&mut adapter, "\rC\rS5\rO\r");
    let _without = open(&format!("slcan+tcp://{address}")).unwrap();
    let (mut adapter, _) = server.accept().unwrap();
    read(&mut adapter, "\rC\rO\r");
}

#[test]
fn an_adapter_that_refuses_to_go_on_the_bus_is_an_error_with_a_cure() {
    let server = TcpListener::bind("127.0.0.1:0").unwrap();
    let mut bus = open(&format!("slcan+tcp://{}", server.local_addr().unwrap())).unwrap();
    let (mut adapter, _) = server.accept().unwrap();
    // It was closed already, which does not matter; and it does not know its bit rate, which does.
    adapter.write_all(b"\r\x07\x07").unwrap();
    let error = bus.receive(LONG).unwrap_err().to_string();
    assert!(error.contains("@500k"), "{error}");
}

#[test]
fn a_bus_that_vanishes_is_an_error_at_once() {
    let (mut listener, address) = listener();
    let mut one = client(&mut listener, address);
    drop(listener);
    let started = Instant::now();
    let error = one.receive(LONG).unwrap_err().to_string();
    assert!(started.elapsed() < LONG);
    assert!(
        error.starts_with(&format!("slcan+tcp://{address}@500k: cannot receive: ")),
        "{error}"
    );
    assert!(
        open(&format!("slcan+tcp://{address}")).is_err(),
        "nobody listens any more"
    );
}

#[test]
fn a_bus_that_is_not_there_says_so() {
    let Err(error) = open("virtua:x") else {
        panic!("it is no bus")
    };
    assert!(error.to_string().contains("slcan+tcp://host:port"), "{error}");
    let Err(error) = open("slcan+tcp://127.0.0.1:1") else {
        panic!("nobody is there")
    };
    assert!(
        error.to_string().starts_with("slcan+tcp://127.0.0.1:1: cannot open: "),
        "{error}"
    );
}

#[test]
fn who_opens_the_same_virtual_bus_is_on_the_same_bus() {
    let (mut one, mut two, mut other) = (
        open("virtual:a").unwrap(),
        open("virtual:a").unwrap(),
        open("virtual:b").unwrap(),
    );
    one.send(&line::frame("123#01")).unwrap();
    expect(&mut two, "123#01");
    silent(&mut one);
    silent(&mut other);
}
