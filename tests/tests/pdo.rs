//! PDOs (CiA 301, 7.2.2 and objects 1400h to 1BFFh).

use lexican_runtime::{Address, NmtCommand, NmtState, od};
use lexican_tests::{
    bus::Bus,
    line,
    network::{node, number, operational, refuse, set},
    simulated::Simulated,
};
use proptest::{prelude::*, sample::select};

const UNSUPPORTED_ACCESS: u32 = 0x0601_0000;
const NO_SUCH_OBJECT: u32 = 0x0602_0000;
const NOT_MAPPABLE: u32 = 0x0604_0041;
const PDO_TOO_LONG: u32 = 0x0604_0042;
const INVALID_VALUE: u32 = 0x0609_0030;

const TPDO_1: &str = "181#44332211665577";
const TPDO_2: &str = "281#77";
const VALID_4: [u8; 4] = [0x81, 0x04, 0, 0x40];

/// Maps `entries` into TPDO 4 of a node that is OPERATIONAL, and makes it valid.
fn map(entries: &[u32]) -> Bus<Simulated> {
    let mut bus = operational();
    for (sub, entry) in (1..).zip(entries) {
        set(&mut bus, 0x1A03, sub, &entry.to_le_bytes());
    }
    set(&mut bus, 0x1A03, 0, &[u8::try_from(entries.len()).expect("a count")]);
    set(&mut bus, 0x1803, 1, &VALID_4);
    bus
}

fn trigger(bus: &mut Bus<Simulated>, number: u16) -> &mut Bus<Simulated> {
    assert!(bus.node().trigger_tpdo(number), "TPDO {number}");
    bus.advance(0)
}

// Transmission types

#[test]
fn a_cyclic_tpdo_is_sent_with_every_so_many_th_sync() {
    let mut bus = operational();
    set(&mut bus, 0x1800, 2, &[3]);
    for _ in 0..2 {
        bus.send("080#")
            .silence()
            .send("080#")
            .silence()
            .send("080#")
            .expect(TPDO_1);
    }
}

#[test]
fn a_parameter_of_one_tpdo_leaves_the_countdown_of_another_alone() {
    let mut bus = operational();
    set(&mut bus, 0x1800, 2, &[3]);
    bus.send("080#").silence().send("080#").silence();
    set(&mut bus, 0x1801, 5, &[0, 0]);
    bus.send("080#").expect(TPDO_1);
}

#[test]
fn an_acyclic_tpdo_is_sent_with_the_sync_after_an_event() {
    let mut bus = operational();
    set(&mut bus, 0x1800, 2, &[0]).send("080#").silence();
    trigger(&mut bus, 1).silence().send("080#").expect(TPDO_1).silence();
    bus.send("080#").silence();
}

#[test]
fn an_event_driven_tpdo_is_sent_at_an_event_and_not_with_sync() {
    for transmission_type in [254, 255] {
        let mut bus = operational();
        set(&mut bus, 0x1801, 2, &[transmission_type]);
        trigger(&mut bus, 2).expect(TPDO_2).silence();
    }
}

#[test]
fn a_changed_object_is_sent_by_the_tpdos_that_carry_it() {
    let mut bus = operational();
    assert!(bus.node().object_changed(Address::new(0x2001, 0)));
    bus.advance(0).expect(TPDO_2).silence();
    assert!(
        !bus.node().object_changed(Address::new(0x6004, 0)),
        "only in a cyclic TPDO"
    );
    assert!(!bus.node().object_changed(Address::new(0x2222, 0)), "no such object");
}

#[test]
fn what_cannot_be_triggered_says_so() {
    let mut bus = node();
    assert!(!bus.node().trigger_tpdo(2), "PRE-OPERATIONAL");
    bus.send("000#0101");
    for number in [0, 1, 3, 4, 513] {
        assert!(!bus.node().trigger_tpdo(number), "TPDO {number}");
    }
    bus.advance(0).silence();
}

#[test]
fn an_event_right_after_the_start_is_not_lost() {
    let mut bus = node();
    bus.node().obey(NmtCommand::Start);
    trigger(&mut bus, 2).expect(TPDO_2);
}

#[test]
fn types_252_and_253_are_sent_at_a_remote_frame_with_the_values_of_sync_or_of_now() {
    for (transmission_type, sent) in [(252, "281#01"), (253, "281#02")] {
        let mut bus = operational();
        set(&mut bus, 0x1801, 2, &[transmission_type]);
        set(&mut bus, 0x1800, 2, &[0]);
        set(&mut bus, 0x2001, 0, &[1]).send("080#").silence();
        set(&mut bus, 0x2001, 0, &[2]).silence();
        bus.send("281#R1").expect(sent).silence();
    }
}

#[test]
fn a_remote_frame_is_answered_unless_bit_30_forbids_it() {
    let mut bus = operational();
    bus.send("281#R1").expect(TPDO_2).send("181#R7").expect(TPDO_1);
    set(&mut bus, 0x1801, 1, &[0x81, 0x02, 0, 0x40]);
    bus.send("281#R1").silence().send("201#R2").silence();
}

#[test]
fn reserved_transmission_types_are_refused() {
    let mut bus = node();
    for reserved in [241, 251] {
        refuse(&mut bus, (0x1800, 2), &[reserved], INVALID_VALUE);
        refuse(&mut bus, (0x1400, 2), &[reserved], INVALID_VALUE);
    }
    for sent_only in [252, 253] {
        refuse(&mut bus, (0x1400, 2), &[sent_only], INVALID_VALUE);
        set(&mut bus, 0x1800, 2, &[sent_only]);
    }
    for both in [0, 240, 254, 255] {
        set(&mut bus, 0x1400, 2, &[both]);
        set(&mut bus, 0x1800, 2, &[both]);
    }
}

#[test]
fn the_sync_start_value_says_with_which_counter_a_cyclic_tpdo_begins() {
    let mut bus = node();
    refuse(&mut bus, (0x1800, 6), &[3], INVALID_VALUE); // it is valid
    set(&mut bus, 0x1800, 1, &[0x81, 0x01, 0, 0x80]);
    refuse(&mut bus, (0x1800, 6), &[241], INVALID_VALUE);
    set(&mut bus, 0x1800, 6, &[3]);
    set(&mut bus, 0x1800, 2, &[2]);
    set(&mut bus, 0x1800, 1, &[0x81, 0x01, 0, 0]);
    set(&mut bus, 0x1019, 0, &[10]).send("000#0101");
    bus.send("080#01")
        .silence()
        .send("080#02")
        .silence()
        .send("080#03")
        .expect(TPDO_1);
    bus.send("080#04").silence().send("080#05").expect(TPDO_1);
}

// Timers

#[test]
fn the_event_timer_sends_when_nothing_else_does() {
    let mut bus = node();
    set(&mut bus, 0x1801, 5, &[100, 0]).send("000#0101").silence();
    bus.advance(99).silence().advance(1).expect(TPDO_2);
    bus.advance(50);
    trigger(&mut bus, 2)
        .expect(TPDO_2)
        .advance(99)
        .silence()
        .advance(1)
        .expect(TPDO_2);
    bus.send("000#8001").advance(1000).silence();
}

#[test]
fn the_event_timer_may_change_while_the_pdo_is_valid() {
    let mut bus = operational();
    set(&mut bus, 0x1801, 5, &[100, 0]).advance(100).expect(TPDO_2);
    set(&mut bus, 0x1801, 5, &[0, 0]).advance(1000).silence();
}

#[test]
fn the_inhibit_time_holds_events_back() {
    let mut bus = node();
    refuse(&mut bus, (0x1801, 3), &[100, 0], INVALID_VALUE); // it is valid
    set(&mut bus, 0x1801, 1, &[0x81, 0x02, 0, 0x80]);
    set(&mut bus, 0x1801, 3, &[100, 0]); // 10 ms
    set(&mut bus, 0x1801, 1, &[0x81, 0x02, 0, 0]).send("000#0101");
    trigger(&mut bus, 2).expect(TPDO_2);
    trigger(&mut bus, 2).silence();
    trigger(&mut bus, 2).silence().advance(9).silence();
    set(&mut bus, 0x2001, 0, &[0x88])
        .advance(1)
        .expect("281#88")
        .advance(100)
        .silence();
}

#[test]
fn a_held_back_tpdo_does_not_hold_back_the_timers_of_others() {
    let mut bus = node();
    set(&mut bus, 0x1801, 1, &[0x81, 0x02, 0, 0x80]);
    set(&mut bus, 0x1801, 3, &[0x10, 0x27]); // 1 s
    set(&mut bus, 0x1801, 5, &[30, 0]);
    set(&mut bus, 0x1801, 1, &[0x81, 0x02, 0, 0]);
    set(&mut bus, 0x1A03, 1, &[8, 0, 1, 0x20]);
    set(&mut bus, 0x1A03, 0, &[1]);
    set(&mut bus, 0x1803, 5, &[40, 0]);
    set(&mut bus, 0x1803, 1, &VALID_4).send("000#0101");
    bus.advance(100)
        .expect(TPDO_2)
        .expect("481#77")
        .expect("481#77")
        .silence();
    bus.advance(929).expect("481#77");
}

#[test]
fn several_tpdos_go_out_in_the_order_of_their_identifiers() {
    let mut bus = operational();
    set(&mut bus, 0x1801, 1, &[0x81, 0x02, 0, 0x80]);
    set(&mut bus, 0x1801, 2, &[1]);
    set(&mut bus, 0x1801, 1, &[0x00, 0x01, 0, 0]); // 100h
    bus.send("080#").expect("100#77").expect(TPDO_1).silence();
}

// Mapping

#[test]
fn the_mapping_changes_by_the_procedure_of_the_standard() {
    let mut bus = map(&[0x2001_0008, 0x6005_0010]);
    trigger(&mut bus, 4).expect("481#776655").silence();
    refuse(&mut bus, (0x1A03, 0), &[0], UNSUPPORTED_ACCESS);
    refuse(&mut bus, (0x1A03, 1), &[8, 0, 1, 0x20], UNSUPPORTED_ACCESS);
    set(&mut bus, 0x1803, 1, &[0x81, 0x04, 0, 0xC0]);
    assert!(!bus.node().trigger_tpdo(4));
    refuse(&mut bus, (0x1A03, 1), &[8, 0, 1, 0x20], UNSUPPORTED_ACCESS);
    set(&mut bus, 0x1A03, 0, &[0]);
    set(&mut bus, 0x1A03, 1, &[0x20, 0, 4, 0x60]);
    set(&mut bus, 0x1A03, 0, &[1]);
    set(&mut bus, 0x1803, 1, &VALID_4);
    trigger(&mut bus, 4).expect("481#44332211");
}

#[test]
fn what_cannot_be_mapped_is_refused() {
    let mut bus = node();
    for (entry, code) in [
        (0x2FFF_0008u32, NO_SUCH_OBJECT),
        (0x2001_0108, NO_SUCH_OBJECT),
        (0x2005_0008, NOT_MAPPABLE),
        (0x6200_0010, NOT_MAPPABLE), // for RPDOs only
        (0x2001_0010, NOT_MAPPABLE), // it has 8 bits
        (0x6004_0018, NOT_MAPPABLE),
        (0x2001_0000, NOT_MAPPABLE),
        (0x0005_0008, NO_SUCH_OBJECT), // dummies are for RPDOs
    ] {
        refuse(&mut bus, (0x1A03, 1), &entry.to_le_bytes(), code);
    }
    set(&mut bus, 0x1A03, 1, &[0; 4]);
    refuse(&mut bus, (0x1A03, 0), &[1], NO_SUCH_OBJECT);
}

#[test]
fn more_than_64_bits_or_more_entries_than_there_are_are_refused() {
    let mut bus = node();
    set(&mut bus, 0x1A03, 1, &0x2002_0040u32.to_le_bytes());
    set(&mut bus, 0x1A03, 2, &0x2003_0001u32.to_le_bytes());
    refuse(&mut bus, (0x1A03, 0), &[2], PDO_TOO_LONG);
    refuse(&mut bus, (0x1A03, 0), &[65], PDO_TOO_LONG);
    refuse(&mut bus, (0x1A03, 0), &[255], PDO_TOO_LONG);
    set(&mut bus, 0x1A03, 0, &[1]);
    set(&mut bus, 0x1803, 1, &VALID_4).send("000#0101");
    trigger(&mut bus, 4).expect("481#0807060504030201");
}

#[test]
fn booleans_may_take_a_bit_each() {
    let mut bus = map(&[0x2003_0001, 0x2004_0001, 0x2001_0008, 0x2004_0008]);
    set(&mut bus, 0x2004, 0, &[1]);
    // 0x77 << 2 | 0b10, and a whole byte of 1 from bit 10 on
    trigger(&mut bus, 4).expect("481#DE0500");
}

#[test]
fn as_many_as_64_bits_are_mapped_one_by_one() {
    let mut bus = map(&[0x2004_0001; 64]);
    set(&mut bus, 0x2004, 0, &[1]);
    trigger(&mut bus, 4).expect("481#FFFFFFFFFFFFFFFF");
}

#[test]
fn a_dummy_entry_leaves_bytes_out_where_the_device_allows_it() {
    let mut bus = node();
    set(&mut bus, 0x1401, 1, &[0x01, 0x03, 0, 0x80]);
    set(&mut bus, 0x1401, 2, &[255]);
    set(&mut bus, 0x1601, 0, &[0]);
    refuse(&mut bus, (0x1601, 1), &0x0007_0020u32.to_le_bytes(), NO_SUCH_OBJECT);
    refuse(&mut bus, (0x1601, 1), &0x0005_0010u32.to_le_bytes(), NOT_MAPPABLE);
    set(&mut bus, 0x1601, 1, &0x0005_0008u32.to_le_bytes());
    set(&mut bus, 0x1601, 2, &0x6200_0010u32.to_le_bytes());
    set(&mut bus, 0x1601, 0, &[2]);
    set(&mut bus, 0x1401, 1, &[0x01, 0x03, 0, 0]).send("000#0101");
    bus.send("301#AA3412").silence();
    assert_eq!(number(&mut bus, 0x6200), 0x1234);
}

#[test]
fn a_valid_tpdo_that_carries_nothing_is_never_sent() {
    for transmission_type in [0, 1, 252, 253, 254] {
        let mut bus = operational();
        set(&mut bus, 0x1803, 2, &[transmission_type]);
        set(&mut bus, 0x1803, 5, &[10, 0]);
        set(&mut bus, 0x1803, 1, &[0x81, 0x04, 0, 0]);
        assert!(!bus.node().trigger_tpdo(4), "type {transmission_type}");
        bus.send("080#").expect(TPDO_1).silence();
        bus.send("481#R0").advance(100).silence();
    }
}

// COB-IDs

#[test]
fn the_identifier_changes_only_while_the_pdo_is_not_valid() {
    let mut bus = node();
    for index in [0x1400, 0x1800] {
        refuse(&mut bus, (index, 1), &[0x85, 0x01, 0, 0], INVALID_VALUE);
        set(&mut bus, index, 1, &[0x00, 0x00, 0, 0x80]);
        refuse(&mut bus, (index, 1), &[0x00, 0x00, 0, 0], INVALID_VALUE); // NMT's
        refuse(&mut bus, (index, 1), &[0x01, 0x06, 0, 0], INVALID_VALUE); // SDO's
        refuse(&mut bus, (index, 1), &[0x85, 0x09, 0, 0], INVALID_VALUE); // more than 11 bits
        set(&mut bus, index, 1, &[0x85, 0x01, 0, 0]);
    }
}

#[test]
fn identifiers_of_29_bits_are_sent_and_received() {
    let mut bus = node();
    for (index, last) in [(0x1801, 0x78), (0x1400, 0x79)] {
        set(&mut bus, index, 1, &[0, 0, 0, 0x80]);
        set(&mut bus, index, 1, &[last, 0x56, 0x34, 0x32]);
    }
    bus.send("000#0101");
    trigger(&mut bus, 2).expect("12345678#77");
    bus.send("12345679#341203");
    assert_eq!(number(&mut bus, 0x6200), 0x1234);
    bus.send("679#FFFF03").send("201#FFFF03");
    assert_eq!(number(&mut bus, 0x6200), 0x1234);
}

// Reception

#[test]
fn an_event_driven_rpdo_takes_effect_at_once_and_in_operational_only() {
    let mut bus = node();
    bus.send("201#341203");
    assert_eq!((number(&mut bus, 0x6200), number(&mut bus, 0x2010)), (0, 5));
    bus.send("000#0101").send("201#341203").silence();
    assert_eq!((number(&mut bus, 0x6200), number(&mut bus, 0x2010)), (0x1234, 3));
}

#[test]
fn a_synchronous_rpdo_takes_effect_with_the_next_sync() {
    let mut bus = operational();
    bus.send("301#3412").send("301#7856");
    assert_eq!(number(&mut bus, 0x6200), 0);
    bus.send("080#").expect(TPDO_1);
    assert_eq!(number(&mut bus, 0x6200), 0x5678);
}

#[test]
fn what_waits_for_sync_is_dropped_with_the_state() {
    let mut bus = operational();
    bus.send("301#3412")
        .send("000#8001")
        .send("000#0101")
        .send("080#")
        .expect(TPDO_1);
    assert_eq!(number(&mut bus, 0x6200), 0);
}

#[test]
fn limits_hold_for_rpdos_object_by_object() {
    let mut bus = operational();
    bus.send("201#34120B").silence();
    assert_eq!((number(&mut bus, 0x6200), number(&mut bus, 0x2010)), (0x1234, 5));
}

#[test]
fn an_rpdo_that_is_too_short_is_reported_until_one_is_long_enough() {
    let mut bus = operational();
    bus.send("201#3412").expect("081#1082110100000000").silence();
    bus.send("201#3412").silence();
    assert_eq!(number(&mut bus, 0x6200), 0);
    bus.send("201#3412030405060708")
        .expect("081#0000000000000000")
        .silence();
    assert_eq!((number(&mut bus, 0x6200), number(&mut bus, 0x2010)), (0x1234, 3));
}

#[test]
fn an_rpdo_that_stays_away_is_reported_until_it_comes() {
    let mut bus = operational();
    set(&mut bus, 0x1400, 5, &[50, 0]).advance(500).silence(); // the first one starts the timer
    bus.send("201#341203").advance(49).silence();
    bus.send("201#341203")
        .advance(49)
        .silence()
        .advance(1)
        .expect("081#5082110100000000");
    bus.advance(500).silence();
    bus.send("201#341203").expect("081#0000000000000000").silence();
}

#[test]
fn what_waits_to_be_sent_is_forgotten_when_the_tpdo_becomes_invalid() {
    let valid = [0x81, 0x02, 0, 0];
    let invalid = [0x81, 0x02, 0, 0x80];
    let mut bus = operational();
    set(&mut bus, 0x1801, 2, &[0]);
    trigger(&mut bus, 2).silence();
    set(&mut bus, 0x1801, 1, &invalid);
    set(&mut bus, 0x1801, 1, &valid);
    bus.send("080#").expect(TPDO_1).silence();

    set(&mut bus, 0x1801, 1, &invalid);
    set(&mut bus, 0x1801, 2, &[254]);
    set(&mut bus, 0x1801, 3, &1000u16.to_le_bytes());
    set(&mut bus, 0x1801, 1, &valid);
    trigger(&mut bus, 2).expect(TPDO_2);
    trigger(&mut bus, 2).silence();
    set(&mut bus, 0x1801, 1, &invalid);
    bus.advance(1000).silence().send("080#").expect(TPDO_1).silence();
}

// NMT

#[test]
fn a_stopped_node_sends_nothing_that_was_requested_before() {
    let mut bus = operational();
    let now = bus.now();
    assert!(bus.node().trigger_tpdo(2));
    bus.node().receive(now, &line::frame("000#8001"));
    bus.advance(0).silence();
    assert_eq!(bus.node().state(), NmtState::PreOperational);
    bus.send("000#0101").advance(100).silence();
}

#[test]
fn reset_communication_restores_the_parameters_after_power_on() {
    let mut bus = map(&[0x2001_0008]);
    bus.send("000#8201").expect("701#00").send("000#0101");
    assert!(!bus.node().trigger_tpdo(4));
    set(&mut bus, 0x1A03, 1, &[0x20, 0, 4, 0x60]);
    bus.send("080#").expect(TPDO_1).silence();
}

#[test]
fn the_values_sent_are_those_of_the_moment_of_sending() {
    let mut bus = operational();
    assert!(bus.node().trigger_tpdo(2));
    od::set(bus.node().device_mut(), Address::new(0x2001, 0), &[0x99]).unwrap();
    bus.advance(0).expect("281#99");
}

proptest! {
    /// Bits as a string, the first object's lowest bit first: nothing of the runtime's arithmetic is in it.
    #[test]
    fn any_mapping_that_is_accepted_is_sent_bit_by_bit(chosen in proptest::collection::vec(select(&MAPPABLE[..]), 1..12)) {
        let mut bus = operational();
        set(&mut bus, 0x2004, 0, &[1]);
        for (sub, (entry, _)) in (1..).zip(&chosen) {
            set(&mut bus, 0x1A03, sub, &entry.to_le_bytes());
        }
        let bits: String = chosen.iter().map(|(entry, value)| low_bits(*value, entry & 0xFF)).collect();
        let count = [u8::try_from(chosen.len()).unwrap()];
        if bits.len() > 64 {
            refuse(&mut bus, (0x1A03, 0), &count, PDO_TOO_LONG);
        } else {
            set(&mut bus, 0x1A03, 0, &count);
            set(&mut bus, 0x1803, 1, &VALID_4);
            trigger(&mut bus, 4).expect(&format!("481#{}", hex(&bits)));
        }
    }
}

/// Entries for TPDOs of [`node`](lexican_tests::network::node), and their values.
const MAPPABLE: [(u32, u64); 7] = [
    (0x2001_0008, 0x77),
    (0x2002_0040, 0x0102_0304_0506_0708),
    (0x2003_0001, 0),
    (0x2004_0001, 1),
    (0x2004_0008, 1),
    (0x6004_0020, 0x1122_3344),
    (0x6005_0010, 0x5566),
];

fn low_bits(value: u64, count: u32) -> String {
    (0..count)
        .map(|bit| if value >> bit & 1 == 1 { '1' } else { '0' })
        .collect()
}

fn hex(bits: &str) -> String {
    let bits: Vec<char> = bits.chars().collect();
    let byte = |bits: &[char]| u8::from_str_radix(&bits.iter().rev().collect::<String>(), 2).expect("bits");
    let bytes: Vec<u8> = bits.chunks(8).map(byte).collect();
    line::hex(&bytes)
}
