//! The SDO client of `lexican-bus`: against the runtime's server over a bus that loses, doubles and damages frames, and against
//! telegrams of the standard.

use std::time::Duration;

use lexican_bus::sdo::{Channel, Client, Failure, Manner, Patience};
use lexican_runtime::{
    AbortCode, Address, Frame, Instant, NodeId,
    od::{Access, DataType},
};
use lexican_tests::{
    bus::Bus,
    line::{frame, hex},
    simulated::{Object, Simulated},
};

type Outcome = Result<Vec<u8>, Failure>;

const TEXT: Address = Address::new(0x2100, 0);
const NUMBER: Address = Address::new(0x2101, 0);
const EMPTY: Address = Address::new(0x2102, 0);

const MANNERS: [Manner; 3] = [Manner::Plain, Manner::Block, Manner::Fastest];

/// As many bytes as several blocks take, none like its neighbours.
fn text(length: usize) -> Vec<u8> {
    (0..length)
        .map(|at| b'!' + u8::try_from(at * 7 % 90).expect("a byte"))
        .collect()
}

fn node(text: Vec<u8>) -> Bus<Simulated> {
    let string = |address, default: Vec<u8>| Object {
        address,
        data_type: DataType::VISIBLE_STRING,
        capacity: 4000,
        default,
        ..Object::number(0x2100, 0, 1, 0).with(Access::WRITE)
    };
    let number = Object::number(NUMBER.index, 0, 4, 0x1122_3344);
    Bus::booted(
        Simulated::new(&[string(TEXT, text), number, string(EMPTY, Vec::new())]),
        1,
    )
}

fn client() -> Client {
    let node_id = NodeId::new(1).expect("a node-ID");
    let timeout = Duration::from_millis(500);
    Client::new(Channel::default_of(node_id), Patience { timeout, attempts: 3 })
}

/// Lets the transfer of `client` run; `fault` says what becomes of each frame, counted in the order of the bus.
fn run(client: &mut Client, bus: &mut Bus<Simulated>, mut fault: impl FnMut(usize, Frame) -> Vec<Frame>) -> Outcome {
    let mut count = 0;
    let mut pass = |frame| {
        count += 1;
        fault(count - 1, frame)
    };
    for _ in 0..100_000 {
        if let Some(frame) = client.poll(bus.now()) {
            for frame in pass(frame) {
                bus.put(frame);
            }
        } else if let Some(outcome) = client.outcome() {
            return outcome;
        } else if let Some(frame) = bus.take() {
            let now = bus.now();
            for frame in pass(frame) {
                client.receive(now, &frame);
            }
        } else {
            bus.advance(1);
        }
    }
    panic!("the transfer does not end");
}

fn sound(_: usize, frame: Frame) -> Vec<Frame> {
    vec![frame]
}

fn read(bus: &mut Bus<Simulated>, address: Address, manner: Manner) -> Outcome {
    let mut client = client();
    client.upload(bus.now(), address, manner);
    run(&mut client, bus, sound)
}

#[test]
fn values_of_every_length_are_read_and_written_in_every_manner() {
    for length in [0, 1, 4, 5, 7, 8, 14, 63, 64, 888, 889, 890, 2000] {
        for manner in MANNERS {
            let mut bus = node(text(length));
            assert_eq!(read(&mut bus, TEXT, manner), Ok(text(length)), "{length} {manner:?}");
            let mut client = client();
            client.download(bus.now(), EMPTY, text(length), manner);
            assert_eq!(run(&mut client, &mut bus, sound), Ok(vec![]), "{length} {manner:?}");
            assert_eq!(
                read(&mut bus, EMPTY, Manner::Plain),
                Ok(text(length)),
                "{length} {manner:?}"
            );
        }
    }
}

#[test]
fn blocks_are_taken_where_they_pay_and_not_where_they_do_not() {
    let frames = |length, manner| {
        let mut bus = node(text(length));
        let mut client = client();
        client.upload(bus.now(), TEXT, manner);
        let mut frames = 0;
        let outcome = run(&mut client, &mut bus, |count, frame| {
            frames = count + 1;
            vec![frame]
        });
        assert_eq!(outcome, Ok(text(length)));
        frames
    };
    assert_eq!(frames(4, Manner::Fastest), 2);
    assert_eq!(frames(63, Manner::Fastest), frames(63, Manner::Plain));
    assert!(frames(2000, Manner::Fastest) < frames(2000, Manner::Plain) * 6 / 10);
}

#[test]
fn a_server_that_refuses_blocks_is_asked_once_and_read_plainly() {
    let mut bus = node(text(100));
    let mut client = client();
    let mut asked = 0;
    for _ in 0..3 {
        client.upload(bus.now(), TEXT, Manner::Fastest);
        let outcome = run(&mut client, &mut bus, |_, sent| {
            let wants_blocks = format!("{sent:?}").starts_with("601#A4");
            asked += u32::from(wants_blocks);
            // A command that the server does not know is refused as block transfers are by one that has none.
            vec![if wants_blocks {
                frame("601#E000210000000000")
            } else {
                sent
            }]
        });
        assert_eq!(outcome, Ok(text(100)));
    }
    assert_eq!(asked, 1);
}

#[test]
fn a_refusal_is_told_with_the_code_of_the_server() {
    let mut bus = node(text(9));
    for manner in MANNERS {
        let absent = Address::new(0x3000, 0);
        let refused = Err(Failure::Refused(AbortCode::NO_SUCH_OBJECT));
        assert_eq!(read(&mut bus, absent, manner), refused);
    }
    let mut client = client();
    client.download(bus.now(), NUMBER, vec![1], Manner::Fastest);
    let refused = Err(Failure::Refused(AbortCode::TOO_SHORT));
    assert_eq!(run(&mut client, &mut bus, sound), refused);
}

/// Each frame of the transfer in turn is treated by `fault`; the value comes nevertheless.
fn survives(length: usize, manner: Manner, fault: impl Fn(Frame) -> Vec<Frame>) {
    for hit in 0.. {
        let mut bus = node(text(length));
        let mut client = client();
        client.upload(bus.now(), TEXT, manner);
        let mut frames = 0;
        let outcome = run(&mut client, &mut bus, |count, frame| {
            frames = count;
            if count == hit { fault(frame) } else { vec![frame] }
        });
        assert_eq!(outcome, Ok(text(length)), "frame {hit}, {manner:?}");
        if frames < hit {
            return;
        }
    }
}

#[test]
fn any_one_frame_may_be_lost() {
    for (length, manner) in [
        (4, Manner::Plain),
        (40, Manner::Plain),
        (1000, Manner::Block),
        (100, Manner::Fastest),
    ] {
        survives(length, manner, |_| vec![]);
    }
}

#[test]
fn any_one_frame_may_come_twice() {
    for (length, manner) in [
        (4, Manner::Plain),
        (40, Manner::Plain),
        (1000, Manner::Block),
        (100, Manner::Fastest),
    ] {
        survives(length, manner, |frame| {
            let from_server = frame.id().number() == 0x581;
            if from_server { vec![frame, frame] } else { vec![frame] }
        });
    }
}

#[test]
fn any_one_answer_may_be_damaged_beyond_sense() {
    for (length, manner) in [(40, Manner::Plain), (1000, Manner::Block)] {
        survives(length, manner, |frame| {
            let from_server = frame.id().number() == 0x581;
            let garbage = Frame::new(frame.id(), &frame.data()[..5]).expect("five bytes");
            if from_server { vec![garbage] } else { vec![frame] }
        });
    }
}

#[test]
fn a_byte_that_changed_on_the_way_is_noticed_by_the_crc_and_read_again() {
    survives(1000, Manner::Block, |frame| {
        let mut data: [u8; 8] = frame.data().try_into().expect("eight bytes");
        let is_segment = frame.id().number() == 0x581 && (1..=127).contains(&data[0]);
        data[4] ^= u8::from(is_segment);
        vec![Frame::full(frame.id(), data)]
    });
}

#[test]
fn the_end_of_a_block_that_is_lost_is_asked_for_and_not_all_of_it() {
    let mut bus = node(text(2000));
    let mut client = client();
    client.upload(bus.now(), TEXT, Manner::Block);
    let mut lost = 0;
    let mut segments = 0;
    let outcome = run(&mut client, &mut bus, |_, frame| {
        let is_segment = frame.id().number() == 0x581 && segments < 200;
        segments += usize::from(is_segment);
        // Number 120 to 127 of the first block; the opening answer is counted, too.
        if is_segment && (121..=128).contains(&segments) {
            lost += 1;
            return vec![];
        }
        vec![frame]
    });
    assert_eq!((outcome, lost), (Ok(text(2000)), 8));
    assert_eq!(client.poll(bus.now()), None);
}

#[test]
fn a_node_that_boots_in_mid_transfer_is_asked_anew_at_once() {
    for (length, manner) in [(40, Manner::Plain), (1000, Manner::Block)] {
        let mut bus = node(text(length));
        let mut client = client();
        client.upload(bus.now(), TEXT, manner);
        let start = bus.now();
        let outcome = run(&mut client, &mut bus, |count, sent| match count {
            4 => vec![frame("000#8101")],
            _ => vec![sent],
        });
        assert_eq!(outcome, Ok(text(length)), "{manner:?}");
        let took = bus.now().as_micros() - start.as_micros();
        assert!(took < 500_000, "{took} µs: the timeout was waited for");
    }
}

#[test]
fn a_node_that_is_silent_is_given_up_after_every_attempt_and_told_so() {
    let mut bus = node(text(9));
    let mut client = client();
    client.upload(bus.now(), TEXT, Manner::Plain);
    let mut sent = Vec::new();
    let outcome = run(&mut client, &mut bus, |_, frame| {
        sent.push(format!("{frame:?}"));
        vec![]
    });
    let awaited = "answer to the request";
    assert_eq!(outcome, Err(Failure::Silent { awaited }));
    let (ask, give_up) = ("601#4000210000000000", "601#8000210000000405");
    assert_eq!(sent, [ask, give_up, ask, give_up, ask, give_up]);
}

/// A client with one attempt that reads 1008h of node 1, after these frames; and what it has sent, the request apart.
fn after(manner: Manner, frames: &[&str]) -> (Option<Outcome>, Vec<String>) {
    let now = Instant::from_millis(0);
    let node_id = NodeId::new(1).expect("a node-ID");
    let patience = Patience {
        attempts: 1,
        ..Patience::default()
    };
    let mut client = Client::new(Channel::default_of(node_id), patience);
    client.upload(now, Address::new(0x1008, 0), manner);
    client.poll(now).expect("the request");
    let mut sent = Vec::new();
    for text in frames {
        client.receive(now, &frame(text));
        sent.extend(std::iter::from_fn(|| client.poll(now)).map(|frame| hex(frame.data())));
    }
    (client.outcome(), sent)
}

fn broken(code: AbortCode) -> Outcome {
    Err(Failure::Broken(code))
}

#[test]
fn four_bytes_count_when_the_server_does_not_say_how_many() {
    let (outcome, sent) = after(Manner::Plain, &["581#4208100057444741"]);
    assert_eq!((outcome, sent), (Some(Ok(b"WDGA".to_vec())), vec![]));
}

#[test]
fn answers_of_others_and_late_ones_are_passed_over() {
    let others = [
        "701#05",               // a heartbeat
        "582#4308100001020304", // another node
        "581#43081000",         // not eight bytes
        "581#4309100001020304", // another object
        "581#8009100000000206", // its abort
        "581#0031323334353637", // a segment of a transfer that is over
        "601#4008100000000000", // another client
    ];
    assert_eq!(after(Manner::Plain, &others), (None, vec![]));
    assert_eq!(after(Manner::Block, &others), (None, vec![]));
}

#[test]
fn segments_have_to_alternate_and_to_be_as_many_as_announced() {
    let announced = "581#4108100009000000";
    let of = |frames: &[&str]| after(Manner::Plain, &[&[announced], frames].concat()).0;
    assert_eq!(
        of(&["581#0031323334353637", "581#1B38390000000000"]),
        Some(Ok(b"123456789".to_vec()))
    );
    assert_eq!(
        of(&["581#1031323334353637"]),
        Some(broken(AbortCode::TOGGLE_NOT_ALTERNATED))
    );
    assert_eq!(of(&["581#0131323334353637"]), Some(broken(AbortCode::TOO_SHORT)));
    let longer = ["581#0031323334353637", "581#1138393031323334"];
    assert_eq!(of(&longer), Some(broken(AbortCode::TOO_LONG)));
    assert_eq!(of(&["581#4308100001020304"]), Some(broken(AbortCode::UNKNOWN_COMMAND)));
}

#[test]
fn the_server_hears_what_it_did_wrong() {
    let (_, sent) = after(Manner::Plain, &["581#4108100009000000", "581#1031323334353637"]);
    assert_eq!(sent, ["6000000000000000", "8008100000000305"]);
}

#[test]
fn the_dialogue_of_a_block_is_the_standard_s() {
    let (outcome, sent) = after(
        Manner::Block,
        &[
            "581#C60810000A000000",
            "581#0130313233343536",
            "581#8237383900000000",
            "581#D1589C0000000000",
        ],
    );
    assert_eq!(outcome, Some(Ok(b"0123456789".to_vec())));
    assert_eq!(sent, ["A300000000000000", "A2027F0000000000", "A100000000000000"]);
}

#[test]
fn a_block_is_refused_whose_crc_or_length_is_wrong() {
    let end = |end| {
        let frames = [
            "581#C60810000A000000",
            "581#0130313233343536",
            "581#8237383900000000",
            end,
        ];
        after(Manner::Block, &frames)
    };
    let (outcome, sent) = end("581#D1599C0000000000");
    assert_eq!(outcome, Some(broken(AbortCode::CRC_ERROR)));
    assert_eq!(sent.last().map(String::as_str), Some("8008100004000405"));
    assert_eq!(end("581#D5589C0000000000").0, Some(broken(AbortCode::TOO_SHORT)));
    assert_eq!(end("581#CD589C0000000000").0, Some(broken(AbortCode::TOO_LONG)));
}

#[test]
fn a_server_that_never_ends_is_stopped() {
    let segment = ["581#0031323334353637", "581#1031323334353637"];
    let frames = [&["581#4108100009000000"][..], &segment, &segment].concat();
    assert_eq!(after(Manner::Plain, &frames).0, Some(broken(AbortCode::TOO_LONG)));
    let block = ["581#0130313233343536", "581#0237383930313233"];
    let frames = [&["581#C608100009000000"][..], &block, &block].concat();
    let (outcome, _) = after(Manner::Block, &frames);
    assert_eq!(outcome, None, "two segments hold nine bytes; the next ones repeat them");
    let frames = [&["581#C608100001000000"][..], &block].concat();
    assert_eq!(after(Manner::Block, &frames).0, Some(broken(AbortCode::TOO_LONG)));
}
