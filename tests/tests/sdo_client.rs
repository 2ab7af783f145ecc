//! The client that dumps: what it reads from a good node, and what it makes of a bad one.

use lexican_eds::dump::{AbortCode, Answer};
use lexican_runtime::{Address, Frame, NodeId};
use lexican_tests::{
    bus::Bus,
    line::frame,
    sample,
    sdo_client::{Step, Upload, upload},
};

const NO_ANSWER: Step = Step::Wait;

fn value(bytes: &[u8]) -> Answer {
    Answer::Value(bytes.to_vec())
}

#[test]
fn a_node_is_read_whether_it_answers_at_once_or_in_segments() {
    let mut bus = Bus::booted(sample::quiet(), 1);
    assert_eq!(
        upload(&mut bus, Address::new(0x1000, 0)),
        value(&[0x96, 0x01, 0x02, 0x00])
    );
    assert_eq!(
        upload(&mut bus, Address::new(0x2003, 0)),
        value(&[0xFB, 0xFF, 0xFF, 0xFF, 0xFF])
    );
    assert_eq!(upload(&mut bus, Address::new(0x1008, 0)), value(b"Lexican sample"));
    bus.silence();
}

#[test]
fn a_refusal_is_an_answer() {
    let mut bus = Bus::booted(sample::quiet(), 1);
    assert_eq!(
        upload(&mut bus, Address::new(0x2008, 0)),
        Answer::Abort(AbortCode::WRITE_ONLY)
    );
    assert_eq!(
        upload(&mut bus, Address::new(0x3000, 0)),
        Answer::Abort(AbortCode::NO_SUCH_OBJECT)
    );
    assert_eq!(
        upload(&mut bus, Address::new(0x1018, 9)),
        Answer::Abort(AbortCode::NO_SUCH_SUB_INDEX)
    );
}

#[test]
fn a_node_that_is_stopped_times_out_and_the_dump_goes_on() {
    let mut bus = Bus::booted(sample::quiet(), 1);
    bus.send("000#0201");
    assert_eq!(upload(&mut bus, Address::new(0x1000, 0)), Answer::Timeout);
    bus.send("000#8001");
    assert_eq!(upload(&mut bus, Address::new(0x1001, 0)), value(&[0]));
}

/// A transfer of 1008h from node 5, and what it says to each of `frames` in turn.
fn steps(frames: &[&str]) -> Vec<Step> {
    let (mut upload, request) = Upload::begin(NodeId::new(5).expect("a node-ID"), Address::new(0x1008, 0));
    assert_eq!(request, frame("605#4008100000000000"));
    frames.iter().map(|text| upload.receive(&frame(text))).collect()
}

fn abort(code: u32) -> Step {
    let [c0, c1, c2, c3] = code.to_le_bytes();
    let request: Frame = frame(&format!("605#80081000{c0:02X}{c1:02X}{c2:02X}{c3:02X}"));
    Step::Abort(request, Answer::Abort(AbortCode(code)))
}

#[test]
fn four_bytes_count_when_the_server_does_not_say_how_many() {
    assert_eq!(steps(&["585#4208100057444741"]), [Step::Done(value(b"WDGA"))]);
}

#[test]
fn frames_of_others_are_passed_over() {
    let heard = ["705#05", "584#4308100001020304", "585#43081000", "605#4008100000000000"];
    assert_eq!(steps(&heard), [NO_ANSWER, NO_ANSWER, NO_ANSWER, NO_ANSWER]);
}

#[test]
fn an_answer_for_another_object_is_refused() {
    assert_eq!(steps(&["585#4309100001020304"]), [abort(0x0504_0001)]);
    assert_eq!(steps(&["585#4108100109000000"]), [abort(0x0504_0001)]);
    assert_eq!(steps(&["585#6008100000000000"]), [abort(0x0504_0001)]);
}

#[test]
fn segments_have_to_alternate_and_to_be_as_many_as_announced() {
    let ask = |command: &str| Step::Send(frame(&format!("605#{command}00000000000000")));
    let (first, second) = (ask("60"), ask("70"));
    let announced = "585#4108100009000000";
    assert_eq!(
        steps(&[announced, "585#0031323334353637", "585#1B38390000000000"]),
        [first.clone(), second.clone(), Step::Done(value(b"123456789"))]
    );
    assert_eq!(
        steps(&[announced, "585#1031323334353637"]),
        [first.clone(), abort(0x0503_0000)]
    );
    assert_eq!(
        steps(&[announced, "585#0131323334353637"]),
        [first.clone(), abort(0x0607_0013)]
    );
    assert_eq!(
        steps(&[announced, "585#0031323334353637", "585#1138393031323334"]),
        [first.clone(), second, abort(0x0607_0012)]
    );
    assert_eq!(steps(&[announced, "585#4308100001020304"]), [first, abort(0x0504_0001)]);
}
