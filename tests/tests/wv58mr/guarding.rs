//! NMT, node guarding and heartbeat (5.2.1, 5.2.2, 5.5.2, 5.5.3, 5.7.2.9, 5.7.2.10, 5.7.2.14).

use crate::device::{Client, delivered};

#[test]
fn the_nmt_states_are_those_of_table_8() {
    let (mut bus, _) = delivered();
    let mut state = |command: &str, answer: &str| {
        bus.send(command).send("701#R1").expect(answer).silence();
    };
    state("000#0101", "701#05");
    state("000#0201", "701#84");
    state("000#8001", "701#7F");
    state("000#0200", "701#84");
    state("000#0100", "701#05");
    state("000#0102", "701#85");
    for (reset, state) in [("000#8101", "701#7F"), ("000#8200", "701#7F")] {
        bus.send(reset).expect("701#00").silence();
        bus.send("701#R1").expect(state).silence();
    }
}

#[test]
fn stopped_serves_no_sdo() {
    let (mut bus, _) = delivered();
    bus.send("000#0201").send("601#4000100000000000").silence();
}

#[test]
fn the_toggle_bit_begins_with_0_and_alternates() {
    let (mut bus, _) = delivered();
    for answer in ["701#7F", "701#FF", "701#7F", "701#FF"] {
        bus.send("701#R1").expect(answer).silence();
    }
}

#[test]
fn a_guard_event_is_told_after_guard_time_times_life_time_factor() {
    let (mut bus, _) = delivered();
    bus.set(0x100C, 0, &[100, 0]).set(0x100D, 0, &[3]);
    // It begins with the first question.
    bus.advance(1000).silence().send("701#R1").expect("701#7F");
    bus.advance(299).silence().send("701#R1").expect("701#FF");
    bus.advance(300).expect("081#3081110000000000").silence();
    bus.send("701#R1").expect("701#7F").expect("081#0000000000000000");
    // Either of them at 0 ends it.
    bus.set(0x100D, 0, &[0]).advance(1000).silence();
}

#[test]
fn the_heartbeat_is_off_or_10_to_65535_ms() {
    let (mut bus, _) = delivered();
    for refused in [1, 9] {
        bus.refuse(0x1017, 0, &[refused, 0], 0x0609_0030);
    }
    bus.set(0x1017, 0, &[10, 0]).advance(0).expect("701#7F");
    bus.advance(10).expect("701#7F").silence();
    bus.send("000#0101").advance(10).expect("701#05").silence();
    bus.send("000#0201").advance(10).expect("701#04").silence();
    bus.send("000#8001")
        .set(0x1017, 0, &[0xFF, 0xFF])
        .advance(0)
        .expect("701#7F");
    bus.advance(65_534).silence().advance(1).expect("701#7F");
    bus.set(0x1017, 0, &[0, 0]).advance(100_000).silence();
}
