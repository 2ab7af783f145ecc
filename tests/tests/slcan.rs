//! slcan: frames as ASCII on a serial line. What is expected is written as Lawicel's manual of the CAN232 writes it.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on stops")]

use lexican_runtime::{
    CanId, Frame,
    wire::slcan::{Answer, Command, Lines},
};
use lexican_tests::line;
use proptest::prelude::*;

/// Each line that `bytes` end, as text.
fn lines(bytes: &[u8]) -> Vec<String> {
    let mut lines = Lines::new();
    let lines = bytes.iter().filter_map(|byte| lines.push(*byte));
    lines.map(|line| line.as_bytes().escape_ascii().to_string()).collect()
}

fn received(frame: &str, timestamp: Option<u16>) -> Answer {
    let frame = line::frame(frame);
    Answer::Received { frame, timestamp }
}

/// What is said, and its line, both ways.
#[track_caller]
fn commands(rows: &[(Command, &str)]) {
    for (command, text) in rows {
        assert_eq!(command.emit().as_bytes(), format!("{text}\r").as_bytes());
        assert_eq!(Command::parse(text.as_bytes()), Some(*command), "{text}");
    }
}

#[test]
fn a_host_opens_closes_and_asks_with_one_letter() {
    commands(&[
        (Command::Nothing, ""),
        (Command::Open, "O"),
        (Command::Listen, "L"),
        (Command::Close, "C"),
        (Command::Status, "F"),
        (Command::Version, "V"),
        (Command::SerialNumber, "N"),
        (Command::BitRate(0), "S0"),
        (Command::BitRate(8), "S8"),
        (Command::BitTiming(0x031C), "s031C"),
        (Command::Timestamps(true), "Z1"),
        (Command::Timestamps(false), "Z0"),
        (Command::AcceptanceCode(0x0012_3000), "M00123000"),
        (Command::AcceptanceMask(0xFFFF_FFFF), "mFFFFFFFF"),
    ]);
}

#[test]
fn a_host_sends_data_and_remote_frames_of_11_and_29_bits() {
    let transmit = |frame| Command::Transmit(line::frame(frame));
    commands(&[
        (transmit("601#4000100000000000"), "t60184000100000000000"),
        (transmit("080#"), "t0800"),
        (transmit("0000012A#11223344"), "T0000012A411223344"),
        (transmit("701#R1"), "r7011"),
        (transmit("1FFFFFFF#R8"), "R1FFFFFFF8"),
    ]);
}

#[test]
fn an_adapter_answers_and_passes_frames_on() {
    let serial_number = Answer::SerialNumber(*b"LX01");
    let version = Answer::Version {
        hardware: 0x10,
        software: 0x13,
    };
    for (answer, text) in [
        (Answer::Done, "\r"),
        (Answer::Refused, "\x07"),
        (Answer::Sent { extended: false }, "z\r"),
        (Answer::Sent { extended: true }, "Z\r"),
        (version, "V1013\r"),
        (serial_number, "NLX01\r"),
        (Answer::Status(0x20), "F20\r"),
        (received("704#7F", None), "t70417F\r"),
        (received("704#7F", Some(0x12)), "t70417F0012\r"),
        (received("704#R1", Some(0xEA5F)), "r7041EA5F\r"),
        (received("00000080#", None), "T000000800\r"),
    ] {
        assert_eq!(answer.emit().as_bytes(), text.as_bytes());
        let line = text.strip_suffix('\r').unwrap_or(text);
        assert_eq!(Answer::parse(line.as_bytes()), Some(answer), "{line}");
    }
}

#[test]
fn small_digits_are_read_too() {
    let frame = line::frame("7AB#CDEF");
    assert_eq!(Command::parse(b"t7ab2cdef"), Some(Command::Transmit(frame)));
}

#[test]
fn what_is_no_command_is_none() {
    for text in [
        "x",
        "o",
        "OO",
        "S",
        "S9",
        "SA",
        "S01",
        "s01",
        "Z2",
        "M123",
        "t",
        "t80",
        "t8000",
        "t1239",
        "t1231",
        "t12311",
        "t1231112",
        "t123111 ",
        "r123",
        "r1239",
        "r123111",
        "T200000000",
        "T1FFFFFFFF",
        "t12+0",
        "\u{e9}",
    ] {
        assert_eq!(Command::parse(text.as_bytes()), None, "{text}");
    }
}

#[test]
fn what_is_no_answer_is_none() {
    for text in [
        "x",
        "zz",
        "V12",
        "V12345",
        "N123",
        "N12345",
        "F",
        "F123",
        "t7041",
        "t70417F0",
        "t70417F000",
        "\x07\x07",
    ] {
        assert_eq!(Answer::parse(text.as_bytes()), None, "{text}");
    }
}

#[test]
fn bytes_become_lines() {
    assert_eq!(lines(b"S6\rO\r\n\rV"), ["S6", "O", ""]);
    assert_eq!(lines(b"\r\x07t7\x07z\r"), ["", "\\x07", "\\x07", "z"]);
}

#[test]
fn a_line_that_is_too_long_is_refused_once_and_the_next_one_understood() {
    let long = [b"T1FFFFFFF8".as_slice(), &[b'0'; 30], b"\rO\r"].concat();
    assert_eq!(lines(&long), ["?", "O"]);
    assert_eq!(Command::parse(b"?"), None);
    assert_eq!(Answer::parse(b"?"), None);
}

#[test]
fn the_longest_line_is_whole() {
    let answer = received("1FFFFFFF#FFFFFFFFFFFFFFFF", Some(59_999));
    let text = "T1FFFFFFF8FFFFFFFFFFFFFFFFEA5F";
    assert_eq!(answer.emit().as_bytes(), format!("{text}\r").as_bytes());
    assert_eq!(lines(format!("{text}\r").as_bytes()), [text]);
}

fn frame() -> impl Strategy<Value = Frame> {
    let id = prop_oneof![
        (0..=0x7FF_u32).prop_map(|number| CanId::standard(number).unwrap()),
        (0..=0x1FFF_FFFF_u32).prop_map(|number| CanId::extended(number).unwrap()),
    ];
    let data = prop_oneof![
        proptest::collection::vec(any::<u8>(), 0..=8).prop_map(Ok),
        (0..=8_u8).prop_map(Err),
    ];
    (id, data).prop_map(|(id, data)| match data {
        Ok(data) => Frame::new(id, &data).unwrap(),
        Err(length) => Frame::remote(id, length).unwrap(),
    })
}

proptest! {
    #[test]
    fn any_frame_comes_back(frame in frame(), timestamp in proptest::option::of(0..60_000_u16)) {
        let answer = Answer::Received { frame, timestamp };
        let mut lines = Lines::new();
        let line = answer.emit().as_bytes().iter().find_map(|byte| lines.push(*byte)).unwrap();
        prop_assert_eq!(Answer::parse(line.as_bytes()), Some(answer));
        let command = Command::Transmit(frame);
        let line = command.emit().as_bytes().iter().find_map(|byte| lines.push(*byte)).unwrap();
        prop_assert_eq!(Command::parse(line.as_bytes()), Some(command));
    }

    #[test]
    fn any_bytes_are_taken(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        let mut lines = Lines::new();
        for line in bytes.iter().filter_map(|byte| lines.push(*byte)) {
            if let Some(command) = Command::parse(line.as_bytes()) {
                prop_assert_eq!(Command::parse(command.emit().as_bytes().strip_suffix(b"\r").unwrap()), Some(command));
            }
            let _ = Answer::parse(line.as_bytes());
        }
    }
}
