//! SYNC (CiA 301, 7.2.5 and objects 1005h, 1006h, 1007h, 1019h).

use lexican_tests::network::{node, operational, refuse, set};

const INVALID_VALUE: u32 = 0x0609_0030;
const DEVICE_STATE: u32 = 0x0800_0022;
const TPDO_1: &str = "181#44332211665577";

#[test]
fn a_pdo_follows_sync_on_the_identifier_that_1005h_says() {
    let mut bus = operational();
    bus.send("080#").expect(TPDO_1).silence();
    set(&mut bus, 0x1005, 0, &[0x90, 0, 0, 0])
        .send("080#")
        .silence()
        .send("090#")
        .expect(TPDO_1);
    set(&mut bus, 0x1005, 0, &[0x90, 0, 0, 0x20])
        .send("090#")
        .silence()
        .send("00000090#")
        .expect(TPDO_1);
}

#[test]
fn sync_is_heeded_in_operational_only() {
    let mut bus = node();
    bus.send("080#").silence();
    bus.send("000#0101").send("080#").expect(TPDO_1);
    bus.send("000#0201").send("080#").silence();
}

#[test]
fn a_sync_of_the_wrong_length_is_reported_once_and_not_taken() {
    let mut bus = operational();
    bus.send("080#01").expect("081#4082110000000000").silence();
    bus.send("080#02").silence();
    bus.send("080#").expect("081#0000000000000000").expect(TPDO_1).silence();
}

#[test]
fn the_counter_is_expected_when_1019h_says_so() {
    let mut bus = node();
    set(&mut bus, 0x1019, 0, &[10]).send("000#0101");
    bus.send("080#01").expect(TPDO_1).silence();
    bus.send("080#").expect("081#4082110000000000").silence();
}

#[test]
fn a_counter_overflow_of_1_or_above_240_is_refused() {
    let mut bus = node();
    for overflow in [1, 241, 255] {
        refuse(&mut bus, (0x1019, 0), &[overflow], INVALID_VALUE);
    }
    for overflow in [2, 240, 0] {
        set(&mut bus, 0x1019, 0, &[overflow]);
    }
}

#[test]
fn the_counter_overflow_stays_while_there_is_a_period() {
    let mut bus = node();
    set(&mut bus, 0x1006, 0, &[0x10, 0x27, 0, 0]);
    refuse(&mut bus, (0x1019, 0), &[10], DEVICE_STATE);
    refuse(&mut bus, (0x1019, 0), &[0], DEVICE_STATE);
    set(&mut bus, 0x1006, 0, &[0; 4]);
    set(&mut bus, 0x1019, 0, &[10]);
}

#[test]
fn an_identifier_of_another_service_is_refused() {
    let mut bus = node();
    refuse(&mut bus, (0x1005, 0), &[0x01, 0x06, 0, 0], INVALID_VALUE);
    refuse(&mut bus, (0x1005, 0), &[0x00, 0x08, 0, 0], INVALID_VALUE);
}

#[test]
fn a_producer_sends_sync_in_pre_operational_and_operational() {
    let mut bus = node();
    set(&mut bus, 0x1006, 0, &[0x10, 0x27, 0, 0]).advance(100).silence(); // 10 ms, but bit 30 is clear
    set(&mut bus, 0x1005, 0, &[0x80, 0, 0, 0x40])
        .advance(9)
        .silence()
        .advance(1)
        .expect("080#")
        .advance(20)
        .expect("080#")
        .expect("080#")
        .silence();
    bus.send("000#0201").advance(100).silence();
    bus.send("000#8001").advance(10).expect("080#").silence();
    refuse(&mut bus, (0x1005, 0), &[0x90, 0, 0, 0x40], INVALID_VALUE);
    set(&mut bus, 0x1005, 0, &[0x80, 0, 0, 0]).advance(100).silence();
}

#[test]
fn a_producer_counts_and_its_own_pdos_follow() {
    let mut bus = node();
    set(&mut bus, 0x1019, 0, &[2]);
    set(&mut bus, 0x1006, 0, &[0x10, 0x27, 0, 0]).send("000#0101");
    set(&mut bus, 0x1005, 0, &[0x80, 0, 0, 0x40])
        .advance(30)
        .expect("080#01")
        .expect(TPDO_1)
        .expect("080#02")
        .expect(TPDO_1)
        .expect("080#01")
        .expect(TPDO_1)
        .silence();
}

#[test]
fn a_reset_ends_the_producer_that_a_client_began() {
    let mut bus = node();
    set(&mut bus, 0x1006, 0, &[0x10, 0x27, 0, 0]);
    set(&mut bus, 0x1005, 0, &[0x80, 0, 0, 0x40]).advance(10).expect("080#");
    bus.send("000#8201").expect("701#00").advance(100).silence();
}

#[test]
fn an_rpdo_that_misses_the_window_waits_for_nothing() {
    let mut bus = node();
    set(&mut bus, 0x1007, 0, &[0xD0, 0x07, 0, 0]).send("000#0101"); // 2 ms
    bus.send("080#")
        .expect(TPDO_1)
        .advance(3)
        .send("301#3412")
        .send("080#")
        .expect(TPDO_1);
    assert_eq!(lexican_tests::network::number(&mut bus, 0x6200), 0);
    bus.advance(1).send("301#3412").advance(5).send("080#").expect(TPDO_1);
    assert_eq!(lexican_tests::network::number(&mut bus, 0x6200), 0x1234);
}

#[test]
fn an_event_driven_tpdo_is_sent_after_the_window_too() {
    let mut bus = node();
    set(&mut bus, 0x1007, 0, &[0xD0, 0x07, 0, 0]); // 2 ms
    set(&mut bus, 0x1801, 1, &[0x81, 0x02, 0, 0x80]);
    set(&mut bus, 0x1801, 3, &[100, 0]); // an inhibit time of 10 ms
    set(&mut bus, 0x1801, 1, &[0x81, 0x02, 0, 0]).send("000#0101");
    assert!(bus.node().trigger_tpdo(2));
    bus.advance(0).expect("281#77").send("080#").expect(TPDO_1);
    assert!(bus.node().trigger_tpdo(2));
    bus.advance(9).silence().advance(1).expect("281#77").silence();
}
