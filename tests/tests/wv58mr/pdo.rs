//! TPDOs (5.2.3, 5.3, 5.7.2.17 to 5.7.2.20, 5.7.2.35).

use crate::device::{Client, delivered, operational};

const INVALID: u32 = 0x0609_0030;
const STATE: u32 = 0x0800_0022;
const READ_ONLY: u32 = 0x0601_0002;

#[test]
fn tpdo_2_answers_every_sync_as_delivered_with_position_and_speed() {
    let (mut bus, shaft) = operational();
    shaft.put(0x0001_0203);
    bus.advance(1).send("080#").expect("281#030201000000").silence();
}

#[test]
fn tpdo_2_answers_every_nth_sync() {
    let (mut bus, _) = operational();
    bus.set(0x1801, 2, &[3]);
    for _ in 0..3 {
        bus.send("080#").silence().send("080#").silence();
        bus.send("080#").expect("281#000000000000").silence();
    }
    bus.set(0x1801, 2, &[240]);
    for _ in 1..240 {
        bus.send("080#").silence();
    }
    bus.send("080#").expect("281#..").silence();
}

#[test]
fn tpdo_1_is_sent_by_its_timer_in_operational_only() {
    let (mut bus, shaft) = delivered();
    shaft.put(5);
    bus.set(0x1800, 5, &[10, 0]).advance(100).silence();
    bus.send("000#0101").advance(9).silence();
    bus.advance(1).expect("181#050000000000").silence();
    bus.advance(10).expect("181#050000000000");
    bus.set(0x1800, 5, &[0, 0]).advance(1000).silence();
}

#[test]
fn the_least_period_is_a_millisecond() {
    let (mut bus, _) = operational();
    bus.set(0x1800, 5, &[1, 0]).advance(5);
    for _ in 0..5 {
        bus.expect("181#000000000000");
    }
    bus.silence();
}

#[test]
fn the_cycle_timer_6200h_is_the_event_timer_of_tpdo_1() {
    let (mut bus, _) = operational();
    bus.set(0x6200, 0, &[20, 0]);
    assert_eq!(bus.get(0x1800, 5), 20);
    bus.advance(20).expect("181#000000000000");
    bus.set(0x1800, 5, &[0xFF, 0xFF]);
    assert_eq!(bus.get(0x6200, 0), 65_535);
    bus.set(0x6200, 0, &[0, 0]);
    assert_eq!(bus.get(0x1800, 5), 0);
    bus.advance(70_000).silence();
}

#[test]
fn the_link_of_6200h_outlives_a_reset_of_communication() {
    let (mut bus, _) = operational();
    bus.set(0x6200, 0, &[20, 0]);
    bus.send("000#8201").expect("701#00");
    assert_eq!(bus.get(0x6200, 0), bus.get(0x1800, 5));
}

#[test]
fn both_tpdos_answer_rtr() {
    let (mut bus, shaft) = operational();
    shaft.put(7);
    bus.advance(1).send("181#R6").expect("181#070000000000");
    bus.send("281#R6").expect("281#070000000000").silence();
}

#[test]
fn type_253_answers_rtr_only() {
    let (mut bus, _) = operational();
    bus.set(0x1800, 5, &[10, 0])
        .set(0x1800, 2, &[253])
        .set(0x1801, 2, &[253]);
    bus.advance(100).send("080#").silence();
    bus.send("181#R6").expect("181#000000000000");
    bus.send("281#R6").expect("281#000000000000").silence();
}

#[test]
fn tpdo_2_has_no_timer_so_that_its_event_driven_types_answer_rtr_only() {
    let (mut bus, _) = operational();
    for event_driven in [254, 255] {
        bus.set(0x1801, 2, &[event_driven]).advance(1000).send("080#").silence();
        bus.send("281#R6").expect("281#000000000000").silence();
    }
}

#[test]
fn rtr_is_not_answered_when_bit_30_forbids_it() {
    let (mut bus, _) = delivered();
    bus.set(0x1800, 1, &[0x81, 0x01, 0x00, 0x40]);
    bus.send("000#0101").send("181#R6").silence();
}

#[test]
fn transmission_types_are_those_of_the_tables() {
    let (mut bus, _) = delivered();
    for allowed in [253, 254, 255] {
        bus.set(0x1800, 2, &[allowed]).set(0x1801, 2, &[allowed]);
    }
    for allowed in [1, 240] {
        bus.set(0x1801, 2, &[allowed]).refuse(0x1800, 2, &[allowed], INVALID);
    }
    for refused in [0, 241, 251, 252] {
        bus.refuse(0x1800, 2, &[refused], INVALID)
            .refuse(0x1801, 2, &[refused], INVALID);
    }
}

#[test]
fn the_mapping_is_fixed() {
    let (mut bus, _) = delivered();
    for index in [0x1A00, 0x1A01] {
        assert_eq!(bus.get(index, 0), 2);
        assert_eq!([bus.get(index, 1), bus.get(index, 2)], [0x6004_0020, 0x6030_0110]);
        bus.refuse(index, 0, &[0], READ_ONLY)
            .refuse(index, 1, &[0x20, 0x00, 0x0C, 0x60], READ_ONLY);
    }
}

#[test]
fn what_is_not_supported_is_read_only_and_what_is_not_there_is_refused() {
    let (mut bus, _) = delivered();
    for (index, sub) in [(0x1800, 3), (0x1801, 3), (0x1801, 5)] {
        assert_eq!(bus.get(index, sub), 0);
        bus.refuse(index, sub, &[1, 0], READ_ONLY);
    }
    for index in [0x1800, 0x1801] {
        for sub in [4, 6] {
            bus.refuse(index, sub, &[1], 0x0609_0011);
        }
    }
}

#[test]
fn identifiers_change_in_pre_operational_only_and_while_they_are_not_valid() {
    let (mut bus, _) = delivered();
    let (other, invalid) = ([0x90, 0x01, 0x00, 0x00], [0x81, 0x01, 0x00, 0x80]);
    bus.refuse(0x1800, 1, &other, INVALID)
        .set(0x1800, 1, &invalid)
        .set(0x1800, 1, &other)
        .set(0x1005, 0, &[0x81, 0, 0, 0])
        .refuse(0x1005, 0, &[0x80, 0, 0, 0x40], INVALID);
    bus.send("000#0101");
    for (index, sub) in [(0x1005, 0), (0x1014, 0), (0x1800, 1), (0x1801, 1)] {
        bus.refuse(index, sub, &[0x92, 0x01, 0x00, 0x80], STATE);
    }
    bus.send("080#").silence().send("081#").expect("281#..").silence();
    bus.send("190#R6").expect("190#000000000000").silence();
}

#[test]
fn no_process_data_in_pre_operational_and_stopped() {
    let (mut bus, _) = delivered();
    bus.send("080#").send("181#R6").silence();
    bus.send("000#0201").send("080#").send("181#R6").silence();
}
