//! Emergencies and what errors leave behind (5.5.1, 5.7.2.2 to 5.7.2.4, 5.7.2.13, 5.7.2.25).

use crate::device::{Client, delivered, eeprom, shaft, switched_on};
use lexican_runtime::{BusState, profile::encoder::Faults};
use lexican_wv58mr::{BusError, ErrorCounters, Variant};

const INVALID: u32 = 0x0609_0030;
const NO_DATA: &str = "581#8003100224000008";

#[test]
fn a_position_error_is_an_alarm_and_is_told_once() {
    let (mut bus, shaft) = delivered();
    shaft.break_down(Faults::POSITION);
    bus.advance(100).expect("081#05FF810000000000").silence();
    assert_eq!([bus.get(0x6503, 0), bus.get(0x1001, 0)], [1, 0x81]);
    shaft.break_down(Faults::NONE);
    bus.advance(1).expect("081#0000000000000000").silence();
    assert_eq!([bus.get(0x6503, 0), bus.get(0x1001, 0)], [0, 0]);
}

#[test]
fn what_is_still_wrong_after_a_reset_is_told_again() {
    let (mut bus, shaft) = delivered();
    shaft.break_down(Faults::REVOLUTIONS);
    bus.advance(1).expect("081#05FF810000000000");
    bus.send("000#8101").advance(1);
    bus.expect("701#00").expect("081#05FF810000000000").silence();
}

#[test]
fn emergencies_wait_in_stopped() {
    let (mut bus, shaft) = delivered();
    bus.send("000#0201");
    shaft.break_down(Faults::POSITION);
    bus.advance(10).silence();
    bus.send("000#8001").expect("081#05FF810000000000").silence();
}

#[test]
fn the_history_has_the_eight_newest_errors_the_latest_first() {
    let (mut bus, shaft) = delivered();
    bus.send("601#4003100100000000").expect("581#8003100124000008");
    for turn in 0..9 {
        let fault = if turn == 8 { Faults::SPEED } else { Faults::POSITION };
        shaft.break_down(fault);
        bus.advance(1)
            .expect(if turn == 8 { "081#12FF.." } else { "081#05FF.." });
        shaft.break_down(Faults::NONE);
        bus.advance(1).expect("081#0000000000000000");
    }
    assert_eq!(bus.get(0x1003, 0), 8);
    assert_eq!([1, 2, 8].map(|sub| bus.get(0x1003, sub)), [0xFF12, 0xFF05, 0xFF05]);
    bus.refuse(0x1003, 0, &[1], INVALID).set(0x1003, 0, &[0]);
    bus.send("601#4003100200000000").expect(NO_DATA);
}

#[test]
fn the_history_outlives_power_off_resets_and_a_restore_until_a_client_empties_it() {
    let (shaft, cells) = (shaft(Variant::MultiTurn4), eeprom());
    let mut bus = switched_on(&shaft, &cells);
    shaft.break_down(Faults::POSITION);
    bus.advance(1).expect("701#00").expect("081#05FF810000000000");
    shaft.break_down(Faults::NONE);
    bus.advance(1).expect("081#0000000000000000");
    bus.set(0x1011, 1, b"load").send("000#8101").expect("701#00");
    assert_eq!([bus.get(0x1003, 0), bus.get(0x1003, 1)], [1, 0xFF05]);
    let mut bus = switched_on(&shaft, &cells);
    bus.advance(1).expect("701#00");
    assert_eq!([bus.get(0x1003, 0), bus.get(0x1003, 1)], [1, 0xFF05]);
    bus.set(0x1003, 0, &[0]);
    let mut bus = switched_on(&shaft, &cells);
    bus.advance(1).expect("701#00");
    assert_eq!(bus.get(0x1003, 0), 0);
}

#[test]
fn bit_31_of_1014h_disables_emergencies_and_the_identifier_changes_then() {
    let (mut bus, shaft) = delivered();
    bus.refuse(0x1014, 0, &[0x85, 0, 0, 0], INVALID)
        .set(0x1014, 0, &[0x81, 0, 0, 0x80]);
    shaft.break_down(Faults::POSITION);
    bus.advance(10).silence();
    assert_eq!([bus.get(0x1001, 0), bus.get(0x1003, 0)], [0x81, 1]);
    bus.set(0x1014, 0, &[0x85, 0, 0, 0])
        .refuse(0x1014, 0, &[0x85, 0, 0, 0x40], INVALID);
    shaft.break_down(Faults::NONE);
    bus.advance(1).expect("085#0000000000000000").silence();
}

#[test]
fn the_bus_is_watched_by_its_error_counters() {
    let (mut bus, _) = delivered();
    let mut counters = ErrorCounters {
        receive: 5,
        transmit: 130,
    };
    bus.slave().0.set_bus_state(BusState::Passive, counters);
    bus.advance(0).expect("081#2081110000000000").silence();
    assert_eq!([bus.get(0x1002, 0), bus.get(0x1001, 0)], [0x0000_8205, 0x11]);
    counters = ErrorCounters::default();
    bus.slave().0.set_bus_state(BusState::Active, counters);
    bus.advance(0).expect("081#0000000000000000").silence();
    assert_eq!([bus.get(0x1002, 0), bus.get(0x1001, 0)], [0, 0]);
    bus.slave().0.set_bus_state(BusState::Off, counters);
    bus.slave().0.set_bus_state(BusState::Active, counters);
    bus.advance(0)
        .expect("081#4081110000000000")
        .expect("081#0000000000000000")
        .silence();
    assert_eq!(bus.get(0x1003, 1), 0x8140);
}

#[test]
fn bus_errors_are_ranked_by_their_frequency() {
    let (mut bus, _) = delivered();
    assert_eq!(bus.get(0x5000, 0), 0);
    for error in [BusError::Stuff, BusError::Stuff, BusError::Acknowledge] {
        bus.slave().0.count_bus_error(error);
    }
    bus.send("601#4000500000000000").expect("581#4300500003000004");
}
