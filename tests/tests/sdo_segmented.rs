//! Segmented SDO transfers, byte by byte (CiA 301, 7.2.4.3).

use lexican_tests::{
    bus::Bus,
    sample::{Quiet, device::Device, quiet},
};

fn bus() -> Bus<Device<Quiet>> {
    Bus::booted(quiet(), 1)
}

/// A bus on which `2009h` is being downloaded, "0123456" being there and three more bytes promised.
fn downloading() -> Bus<Device<Quiet>> {
    let mut bus = bus();
    bus.send("601#210920000A000000")
        .expect("581#6009200000000000")
        .send("601#0030313233343536")
        .expect("581#2000000000000000");
    bus
}

/// A bus on which `1008h` is being uploaded, seven bytes of fourteen being there.
fn uploading() -> Bus<Device<Quiet>> {
    let mut bus = bus();
    bus.send("601#4008100000000000")
        .expect("581#410810000E000000")
        .send("601#6000000000000000")
        .expect("581#004C65786963616E");
    bus
}

const TAG: &str = "581#4709200074616700";

#[test]
fn a_string_is_read_in_segments_of_seven_bytes() {
    uploading()
        .send("601#7000000000000000")
        .expect("581#112073616D706C65")
        // The transfer is over.
        .send("601#6000000000000000")
        .expect("581#8000000001000405");
}

#[test]
fn a_string_is_written_in_segments_and_has_the_length_that_came() {
    downloading()
        .send("601#1937383900000000")
        .expect("581#3000000000000000")
        .send("601#4009200000000000")
        .expect("581#410920000A000000")
        .send("601#6000000000000000")
        .expect("581#0030313233343536")
        .send("601#7000000000000000")
        .expect("581#1937383900000000");
}

#[test]
fn a_number_of_more_than_four_bytes_goes_in_segments() {
    bus()
        .send("601#2102200008000000")
        .expect("581#6002200000000000")
        .send("601#0011223344556677")
        .expect("581#2000000000000000")
        .send("601#1D88000000000000")
        .expect("581#3000000000000000")
        .send("601#4002200000000000")
        .expect("581#4102200008000000")
        .send("601#6000000000000000")
        .expect("581#0011223344556677")
        .send("601#7000000000000000")
        .expect("581#1D88000000000000");
}

#[test]
fn an_integer40_keeps_its_sign_and_its_limits() {
    let mut bus = bus();
    bus.send("601#4003200000000000")
        .expect("581#4103200005000000")
        .send("601#6000000000000000")
        .expect("581#05FBFFFFFFFF0000") // −5
        .send("601#2103200005000000")
        .expect("581#6003200000000000")
        .send("601#0518FCFFFFFF0000") // −1000
        .expect("581#2000000000000000");
    assert_eq!(bus.node().device().od.offset, -1000);
    bus.send("601#2003200000000000")
        .expect("581#6003200000000000")
        .send("601#0517FCFFFFFF0000") // −1001
        .expect("581#8003200032000906");
    assert_eq!(bus.node().device().od.offset, -1000);
}

#[test]
fn a_time_of_day_is_six_bytes() {
    let mut bus = bus();
    bus.send("601#2007200000000000")
        .expect("581#6007200000000000")
        .send("601#0301000000100000") // 1 ms into day 16
        .expect("581#2000000000000000");
    let clock = bus.node().device().od.clock;
    assert_eq!((clock.days(), clock.milliseconds()), (0x10, 1));
    bus.send("601#4007200000000000").expect("581#4107200006000000");
}

#[test]
fn a_number_of_few_bytes_may_be_written_in_segments_with_or_without_a_size() {
    for initiate in ["601#2117100002000000", "601#2017100000000000"] {
        bus()
            .send(initiate)
            .expect("581#6017100000000000")
            .send("601#0B10270000000000")
            .expect("581#2000000000000000")
            .expect("701#7F") // it is the heartbeat time
            .send("601#4017100000000000")
            .expect("581#4B17100010270000");
    }
}

#[test]
fn an_empty_string_is_a_transfer_of_one_empty_segment() {
    bus()
        .send("601#2109200000000000")
        .expect("581#6009200000000000")
        .send("601#0F00000000000000")
        .expect("581#2000000000000000")
        .send("601#4009200000000000")
        .expect("581#4109200000000000")
        .send("601#6000000000000000")
        .expect("581#0F00000000000000");
}

#[test]
fn an_announced_size_that_does_not_fit_is_refused_at_once() {
    bus()
        .send("601#2109200015000000") // 21 bytes into 20
        .expect("581#8009200012000706")
        .send("601#2109200014000000")
        .expect("581#6009200000000000")
        .send("601#2102200007000000")
        .expect("581#8002200013000706")
        .send("601#21092000FFFFFFFF")
        .expect("581#8009200012000706");
}

#[test]
fn more_bytes_than_the_object_holds_are_refused() {
    bus()
        .send("601#2009200000000000")
        .expect("581#6009200000000000")
        .send("601#0030303030303030")
        .expect("581#2000000000000000")
        .send("601#1030303030303030")
        .expect("581#3000000000000000")
        .send("601#0030303030303030")
        .expect("581#8009200012000706")
        .send("601#4009200000000000")
        .expect(TAG);
}

#[test]
fn more_or_fewer_bytes_than_announced_are_refused() {
    downloading()
        .send("601#1730000000000000") // four
        .expect("581#8009200012000706")
        .send("601#4009200000000000")
        .expect(TAG);
    downloading()
        .send("601#1B30300000000000") // two
        .expect("581#8009200013000706")
        .send("601#4009200000000000")
        .expect(TAG);
}

#[test]
fn a_last_segment_that_does_not_say_its_size_ends_with_the_announced_one() {
    let mut bus = downloading();
    bus.send("601#1137383900000000").expect("581#3000000000000000");
    assert_eq!(bus.node().device().od.tag.as_bytes(), b"0123456789");
    bus.send("601#2017100000000000")
        .expect("581#6017100000000000")
        .send("601#01E8030000000000")
        .expect("581#2000000000000000");
    assert_eq!(bus.node().device().od.producer_heartbeat_time, 1000);
}

#[test]
fn a_toggle_bit_that_does_not_alternate_ends_the_transfer() {
    downloading()
        .send("601#0937383900000000")
        .expect("581#8009200000000305")
        .send("601#1937383900000000")
        .expect("581#8000000001000405")
        .send("601#4009200000000000")
        .expect(TAG);
    uploading()
        .send("601#6000000000000000")
        .expect("581#8008100000000305")
        .send("601#7000000000000000")
        .expect("581#8000000001000405");
}

#[test]
fn a_segment_of_the_other_direction_ends_the_transfer() {
    downloading()
        .send("601#7000000000000000")
        .expect("581#8009200001000405")
        .send("601#1937383900000000")
        .expect("581#8000000001000405");
    uploading()
        .send("601#1937383900000000")
        .expect("581#8008100001000405")
        .send("601#7000000000000000")
        .expect("581#8000000001000405");
}

#[test]
fn a_new_initiate_takes_over_and_nothing_of_the_old_transfer_is_stored() {
    downloading()
        .send("601#4000200000000000")
        .expect("581#4F00200005000000")
        .silence()
        .send("601#1937383900000000")
        .expect("581#8000000001000405")
        .send("601#4009200000000000")
        .expect(TAG);
    uploading()
        .send("601#210920000A000000")
        .expect("581#6009200000000000")
        .send("601#7000000000000000")
        .expect("581#8009200001000405");
}

#[test]
fn a_refused_initiate_ends_the_old_transfer_too() {
    uploading()
        .send("601#40FF5F0000000000")
        .expect("581#80FF5F0000000206")
        .send("601#7000000000000000")
        .expect("581#8000000001000405");
}

#[test]
fn an_abort_of_the_client_ends_the_transfer_without_an_answer() {
    downloading()
        .send("601#8009200000000008")
        .silence()
        .advance(10_000)
        .silence()
        .send("601#4009200000000000")
        .expect(TAG);
}

#[test]
fn a_transfer_that_is_left_open_times_out() {
    uploading()
        .advance(999)
        .silence()
        .advance(1)
        .expect("581#8008100000000405")
        .advance(10_000)
        .silence()
        .send("601#7000000000000000")
        .expect("581#8000000001000405");
    downloading()
        .advance(1000)
        .expect("581#8009200000000405")
        .send("601#4009200000000000")
        .expect(TAG);
}

#[test]
fn each_segment_gives_the_client_its_time_anew() {
    uploading()
        .advance(900)
        .send("601#7000000000000000")
        .expect("581#112073616D706C65")
        .advance(10_000)
        .silence();
    let mut bus = bus();
    bus.node().set_sdo_timeout(50);
    bus.send("601#2009200000000000")
        .expect("581#6009200000000000")
        .advance(40)
        .send("601#0030303030303030")
        .expect("581#2000000000000000")
        .advance(49)
        .silence()
        .advance(1)
        .expect("581#8009200000000405");
}

#[test]
fn an_upload_is_what_the_value_was_when_it_began() {
    let mut bus = bus();
    bus.node().device_mut().od.serial = 0x1111_1111_1111_1111;
    bus.send("601#4002200000000000").expect("581#4102200008000000");
    bus.node().device_mut().od.serial = 0x2222_2222_2222_2222;
    bus.send("601#6000000000000000")
        .expect("581#0011111111111111")
        .send("601#7000000000000000")
        .expect("581#1D11000000000000");

    bus.node().device_mut().od.tag.set(b"one string").unwrap();
    bus.send("601#4009200000000000").expect("581#410920000A000000");
    bus.node().device_mut().od.tag.set(b"another").unwrap();
    bus.send("601#6000000000000000")
        .expect("581#006F6E6520737472")
        .send("601#7000000000000000")
        .expect("581#19696E6700000000");
}
