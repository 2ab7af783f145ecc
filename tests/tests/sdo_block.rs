//! Block SDO transfers, byte by byte (CiA 301, 7.2.4.3.9 to 7.2.4.3.16).

use lexican_runtime::sdo::crc;
use lexican_tests::{
    bus::Bus,
    sample::{Quiet, device::Device, quiet},
};

fn bus() -> Bus<Device<Quiet>> {
    Bus::booted(quiet(), 1)
}

/// A bus on which "0123456789" is being downloaded to 2009h with a CRC; nothing of it is there.
fn downloading() -> Bus<Device<Quiet>> {
    let mut bus = bus();
    bus.send("601#C60920000A000000").expect("581#A40920007F000000");
    bus
}

/// A bus on which 1008h, 14 bytes, is being uploaded with a CRC in blocks of so many segments.
fn uploading(block_size: u8) -> Bus<Device<Quiet>> {
    let mut bus = bus();
    bus.send(&format!("601#A4081000{block_size:02X}000000"))
        .expect("581#C60810000E000000")
        .silence();
    bus
}

const TAG: &str = "581#4709200074616700";

#[test]
fn a_string_is_written_in_a_block_and_stored_at_the_end() {
    let mut bus = downloading();
    bus.send("601#0130313233343536")
        .silence()
        .send("601#8237383900000000")
        .expect("581#A2027F0000000000");
    assert_eq!(bus.node().device().od.tag.as_bytes(), b"tag");
    bus.send("601#D1589C0000000000").expect("581#A100000000000000");
    assert_eq!(bus.node().device().od.tag.as_bytes(), b"0123456789");
    bus.send("601#0130313233343536").expect("581#8000000001000405"); // it is over
}

#[test]
fn a_wrong_crc_is_refused_and_nothing_is_stored_but_a_client_without_one_is_believed() {
    downloading()
        .send("601#0130313233343536")
        .send("601#8237383900000000")
        .expect("581#A2027F0000000000")
        .send("601#D1599C0000000000")
        .expect("581#8009200004000405")
        .send("601#4009200000000000")
        .expect(TAG);
    let mut bus = bus();
    bus.send("601#C20920000A000000")
        .expect("581#A00920007F000000")
        .send("601#0130313233343536")
        .send("601#8237383900000000")
        .expect("581#A2027F0000000000")
        .send("601#D1FFFF0000000000")
        .expect("581#A100000000000000");
    assert_eq!(bus.node().device().od.tag.as_bytes(), b"0123456789");
}

#[test]
fn what_follows_a_lost_segment_is_sent_again() {
    let mut bus = downloading();
    bus.send("601#8237383900000000") // the first one is lost
        .expect("581#A2007F0000000000")
        .send("601#0130313233343536")
        .send("601#0130313233343536") // twice: the second one is dropped
        .silence()
        .send("601#8337383900000000") // as is one that is too far
        .expect("581#A2017F0000000000")
        .send("601#8137383900000000") // the next block begins behind the first segment
        .expect("581#A2017F0000000000")
        .send("601#D1589C0000000000")
        .expect("581#A100000000000000");
    assert_eq!(bus.node().device().od.tag.as_bytes(), b"0123456789");
}

#[test]
fn the_sequence_number_0_is_refused() {
    downloading()
        .send("601#0030313233343536")
        .expect("581#8009200003000405")
        .send("601#4009200000000000")
        .expect(TAG);
}

#[test]
fn sizes_are_held_against_the_object_and_the_promise() {
    let mut bus = bus();
    bus.send("601#C609200015000000") // 21 bytes into 20
        .expect("581#8009200012000706")
        .send("601#C602200007000000") // 7 bytes of an UNSIGNED64
        .expect("581#8002200013000706");
    downloading() // a byte fewer
        .send("601#0130313233343536")
        .send("601#8237383900000000")
        .expect("581#A2027F0000000000")
        .send("601#D5589C0000000000")
        .expect("581#8009200013000706");
    downloading() // a byte more
        .send("601#0130313233343536")
        .send("601#8237383900000000")
        .expect("581#A2027F0000000000")
        .send("601#CD589C0000000000")
        .expect("581#8009200012000706");
    downloading() // a segment more
        .send("601#0130313233343536")
        .send("601#0237383900000000")
        .silence()
        .send("601#0337383900000000")
        .expect("581#8009200012000706")
        .send("601#4009200000000000")
        .expect(TAG);
}

#[test]
fn a_client_may_leave_the_size_open_and_write_nothing_at_all() {
    let mut bus = bus();
    bus.send("601#C409200000000000")
        .expect("581#A40920007F000000")
        .send("601#8100000000000000")
        .expect("581#A2017F0000000000")
        .send("601#DD00000000000000")
        .expect("581#A100000000000000");
    assert_eq!(bus.node().device().od.tag.as_bytes(), b"");
    bus.send("601#A40920007F000000")
        .expect("581#C609200000000000")
        .send("601#A300000000000000")
        .expect("581#8100000000000000")
        .send("601#A2017F0000000000")
        .expect("581#DD00000000000000")
        .send("601#A100000000000000")
        .silence();
}

#[test]
fn numbers_of_any_length_go_in_blocks_too() {
    let mut bus = bus();
    bus.send("601#C202200008000000")
        .expect("581#A00220007F000000")
        .send("601#0111223344556677")
        .send("601#8288000000000000")
        .expect("581#A2027F0000000000")
        .send("601#D900000000000000")
        .expect("581#A100000000000000");
    assert_eq!(bus.node().device().od.serial, 0x8877_6655_4433_2211);
    bus.send("601#A000200001000000") // one byte, no switch allowed
        .expect("581#C200200001000000")
        .send("601#A300000000000000")
        .expect("581#8105000000000000")
        .send("601#A201010000000000")
        .expect("581#D900000000000000");
    bus.send("601#C200200001000000")
        .expect("581#A00020007F000000")
        .send("601#810B000000000000")
        .expect("581#A2017F0000000000")
        .send("601#D900000000000000") // 11 is above the limit
        .expect("581#8000200031000906");
}

#[test]
fn a_string_is_read_in_a_block_and_its_end_has_the_crc() {
    assert_eq!(crc(0, b"Lexican sample"), 0x671F);
    uploading(127)
        .send("601#A300000000000000")
        .expect("581#014C65786963616E")
        .expect("581#822073616D706C65")
        .silence()
        .send("601#A2027F0000000000")
        .expect("581#C11F670000000000")
        .send("601#A100000000000000")
        .silence()
        .advance(10_000)
        .silence();
}

#[test]
fn a_block_has_the_size_that_the_client_asked_for_last() {
    uploading(1)
        .send("601#A300000000000000")
        .expect("581#014C65786963616E")
        .silence()
        .send("601#A201050000000000")
        .expect("581#812073616D706C65")
        .silence()
        .send("601#A201000000000000") // no block follows
        .expect("581#C11F670000000000");
    uploading(1)
        .send("601#A300000000000000")
        .expect("581#014C65786963616E")
        .send("601#A201800000000000")
        .expect("581#8008100002000405");
}

#[test]
fn segments_that_the_client_missed_come_again_and_count_once() {
    uploading(127)
        .send("601#A300000000000000")
        .expect("581#014C65786963616E")
        .expect("581#822073616D706C65")
        .send("601#A2007F0000000000")
        .expect("581#014C65786963616E")
        .expect("581#822073616D706C65")
        .send("601#A201010000000000")
        .expect("581#812073616D706C65")
        .send("601#A201010000000000")
        .expect("581#C11F670000000000");
}

#[test]
fn more_than_was_sent_cannot_be_acknowledged() {
    uploading(127)
        .send("601#A300000000000000")
        .expect("581#014C65786963616E")
        .expect("581#822073616D706C65")
        .send("601#A2037F0000000000")
        .expect("581#8008100003000405");
}

#[test]
fn a_block_of_no_or_of_128_segments_is_refused() {
    bus()
        .send("601#A408100000000000")
        .expect("581#8008100002000405")
        .send("601#A408100080000000")
        .expect("581#8008100002000405")
        .send("601#A40810007F000000")
        .expect("581#C60810000E000000");
}

#[test]
fn a_value_up_to_the_threshold_is_sent_by_another_protocol() {
    bus()
        .send("601#A40810007F0D0000") // 13 bytes: too few
        .expect("581#C60810000E000000")
        .send("601#A40810007F0E0000")
        .expect("581#410810000E000000")
        .send("601#6000000000000000")
        .expect("581#004C65786963616E")
        .send("601#7000000000000000")
        .expect("581#112073616D706C65")
        .send("601#A40010007F040000")
        .expect("581#4300100096010200");
}

#[test]
fn a_block_is_sent_a_segment_a_poll_and_a_request_ends_it() {
    let mut bus = uploading(127);
    let now = bus.now();
    let frame = |text| lexican_tests::line::frame(text);
    let node = bus.node();
    node.receive(now, &frame("601#A300000000000000"));
    assert_eq!(node.poll(now), Some(frame("581#014C65786963616E")));
    assert!(node.poll_at().is_some_and(|due| due <= now), "the rest is waiting");
    // The client has seen that it missed something: what it did not get comes again.
    node.receive(now, &frame("601#A2007F0000000000"));
    assert_eq!(node.poll(now), Some(frame("581#014C65786963616E")));
    node.receive(now, &frame("601#4000200000000000"));
    assert_eq!(node.poll(now), Some(frame("581#4F00200005000000")));
    assert_eq!(node.poll(now), None);
}

#[test]
fn the_client_has_its_time_from_the_end_of_a_block_on() {
    let mut bus = uploading(127);
    let start = bus.now();
    let frame = |text| lexican_tests::line::frame(text);
    let late = |millis: u64| lexican_runtime::Instant::from_micros(start.as_micros() + millis * 1000);
    let node = bus.node();
    node.receive(start, &frame("601#A300000000000000"));
    assert_eq!(node.poll(start), Some(frame("581#014C65786963616E")));
    // The bus was busy for long.
    assert_eq!(node.poll(late(5000)), Some(frame("581#822073616D706C65")));
    assert_eq!(node.poll(late(5999)), None);
    assert_eq!(node.poll(late(6000)), Some(frame("581#8008100000000405")));
}

#[test]
fn an_abort_of_the_client_ends_a_block_in_either_direction() {
    downloading()
        .send("601#0130313233343536")
        .send("601#8009200000000008")
        .silence()
        .send("601#4009200000000000")
        .expect(TAG);
    let mut bus = uploading(127);
    let now = bus.now();
    let frame = |text| lexican_tests::line::frame(text);
    bus.node().receive(now, &frame("601#A300000000000000"));
    bus.node().receive(now, &frame("601#8008100000000008"));
    assert_eq!(bus.node().poll(now), None);
}
