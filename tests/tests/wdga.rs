//! The virtual WDGA, as a client on its bus sees it: what the manual says of its objects and its behaviour.

use lexican_runtime::{
    BusState, Instant,
    profile::encoder::{Faults, Shaft},
    storage::NoStorage,
};
use lexican_tests::{
    encoder::{Hand, WdgaBus, switched_on, wdga},
    memory::Memory,
};
use lexican_wdga::{Encoder, Label, Variant};

/// A multiturn encoder that has booted as node 127, and its shaft.
fn booted() -> (WdgaBus<Memory>, Hand) {
    let (mut bus, hand) = wdga(Variant::Multiturn, Memory::eeprom(4096));
    bus.advance(0).expect("77F#00");
    (bus, hand)
}

/// Writes `bytes` of an expedited request to node 127, which acknowledges.
#[track_caller]
fn write(bus: &mut WdgaBus<Memory>, request: &str) {
    let address = &request[2..8];
    bus.send(&format!("67F#{request}"))
        .expect(&format!("5FF#60{address}00000000"));
}

/// Node 127 refuses it with this abort code, as on the bus.
#[track_caller]
fn refuse(bus: &mut WdgaBus<Memory>, request: &str, code: &str) {
    let address = &request[2..8];
    bus.send(&format!("67F#{request}"))
        .expect(&format!("5FF#80{address}{code}"));
}

/// 6004h of node 127.
#[track_caller]
fn position(bus: &mut WdgaBus<Memory>, bytes: &str) {
    bus.send("67F#4004600000000000").expect(&format!("5FF#43046000{bytes}"));
}

#[test]
fn it_listens_for_the_bit_rate_before_it_boots() {
    let hand = Hand::new(lexican_wdga::shaft(Variant::Multiturn));
    let mut encoder = Encoder::new(hand, NoStorage, Label::default());
    assert_eq!(encoder.bit_rate(), lexican_wdga::BitRate::AUTOMATIC);
    let now = Instant::from_millis(1);
    assert_eq!(encoder.poll(now), None);
    assert_eq!(encoder.poll_at(), None);
    encoder.detected(lexican_wdga::BitRate::KBIT_250);
    assert_eq!(encoder.bit_rate(), lexican_wdga::BitRate::KBIT_250);
    let boot_up = encoder.poll(now).expect("a boot-up message");
    assert_eq!(format!("{boot_up:?}"), "77F#00");
}

#[test]
fn a_multiturn_and_a_singleturn_encoder_say_what_they_are() {
    let (mut bus, _) = booted();
    bus.send("67F#4000100000000000").expect("5FF#4300100096010200");
    bus.send("67F#4002650000000000").expect("5FF#4B026500FFFF0000");
    bus.send("67F#4008100000000000").expect("5FF#410810000A000000");
    bus.send("67F#6000000000000000").expect("5FF#00574447412D4D54");
    bus.send("67F#7000000000000000").expect("5FF#192D434F00000000");

    let (mut bus, _) = wdga(Variant::Singleturn, Memory::eeprom(4096));
    bus.advance(0).expect("77F#00");
    bus.send("67F#4000100000000000").expect("5FF#4300100096010100");
    bus.send("67F#4002650000000000").expect("5FF#4B02650001000000");
    bus.send("67F#4002600000000000").expect("5FF#4302600000400000");
}

#[test]
fn the_position_follows_the_shaft_and_a_preset_moves_it() {
    let (mut bus, hand) = booted();
    position(&mut bus, "00000000");
    hand.turn(0x1234);
    position(&mut bus, "34120000");
    hand.turn(16384);
    position(&mut bus, "34520000");
    // Table 8.65: the zero position is here.
    write(&mut bus, "2303600000000000");
    position(&mut bus, "00000000");
    bus.send("67F#4009650000000000").expect("5FF#43096500CCADFFFF");
    hand.turn(-1);
    position(&mut bus, "FFFFFFFF");
    // 6008h moves by the same way, on its longer circle.
    bus.send("67F#4008600000000000").expect("5FF#4108600008000000");
    bus.send("67F#6000000000000000").expect("5FF#00FFFFFFFFFFFF1F");
    bus.send("67F#7000000000000000").expect("5FF#1D00000000000000");
}

#[test]
fn a_preset_with_64_bits_moves_the_position_with_32_too() {
    let (mut bus, hand) = booted();
    hand.turn(5);
    bus.send("67F#2109600008000000").expect("5FF#6009600000000000");
    bus.send("67F#0011223344000000").expect("5FF#2000000000000000");
    bus.send("67F#1D00000000000000").expect("5FF#3000000000000000");
    position(&mut bus, "11223344");
    hand.turn(1);
    position(&mut bus, "12223344");
    // 2⁵³ is no position any more: the circle of 6008h has 2³⁹ revolutions of 2¹⁴ steps.
    bus.send("67F#2109600008000000").expect("5FF#6009600000000000");
    bus.send("67F#0000000000000020").expect("5FF#2000000000000000");
    bus.send("67F#1D00000000000000").expect("5FF#8009600031000906");
}

#[test]
fn counting_direction_and_scaling_are_set_as_chapter_8_6_says() {
    let (mut bus, hand) = booted();
    hand.turn(16384 + 4);
    // Table 8.62: counter-clockwise; the status (6500h) follows.
    write(&mut bus, "2B00600005000000");
    bus.send("67F#4000650000000000").expect("5FF#4B00650005000000");
    position(&mut bus, "FCBFFFFF");
    write(&mut bus, "2B00600004000000");
    // Table 8.63: 4096 units a revolution.
    write(&mut bus, "2301600000100000");
    position(&mut bus, "01100000");
    // A range of 5000 units needs no power of two: 4097 and another revolution are 8193, 3193 of the next round.
    write(&mut bus, "2302600088130000");
    hand.turn(16384);
    position(&mut bus, "790C0000");
    refuse(&mut bus, "230260000F000000", "32000906");
    refuse(&mut bus, "2301600089130000", "31000906");
    refuse(&mut bus, "2303600088130000", "31000906");
    // Off: the sensor's own steps.
    write(&mut bus, "2B00600000000000");
    position(&mut bus, "04800000");
    bus.send("67F#4000650000000000").expect("5FF#4B00650000000000");
    // Bits that mean nothing.
    refuse(&mut bus, "2B00600002000000", "30000906");
}

#[test]
fn pdo_1_goes_out_when_the_position_changes_and_only_then() {
    let (mut bus, hand) = booted();
    bus.send("000#017F").advance(100).silence();
    hand.turn(0x10);
    bus.advance(1).expect("1FF#10000000");
    bus.advance(100).silence();
    hand.turn(-1);
    bus.advance(1).expect("1FF#0F000000").silence();
    // PDO2 and PDO3 answer every SYNC with the position of that moment; it has changed, so PDO1 goes too.
    hand.turn(1);
    bus.send("080#");
    bus.expect("1FF#10000000")
        .expect("2FF#10000000")
        .expect("3FF#1000000000000000");
    bus.silence();
}

#[test]
fn a_node_id_written_to_2101h_counts_after_a_reset_and_outlives_restore_and_power_off() {
    let memory = Memory::eeprom(4096);
    let (mut bus, hand) = wdga(Variant::Multiturn, memory.clone());
    bus.advance(0).expect("77F#00");
    write(&mut bus, "2F01210004000000");
    bus.send("67F#4001210000000000").expect("5FF#4F01210004000000");
    bus.send("000#8100").expect("704#00");
    bus.send("604#231110016C6F6164").expect("584#6011100100000000");
    let mut bus = switched_on(&hand, memory);
    bus.advance(0).expect("704#00");
    // Table 8.47: the COB-IDs follow.
    bus.send("604#4000180100000000").expect("584#4300180184010040");
    bus.send("604#4014100000000000").expect("584#4314100084000000");
}

#[test]
fn baud_rate_and_node_id_change_in_preoperational_only() {
    let (mut bus, _) = booted();
    bus.send("000#017F");
    refuse(&mut bus, "2F01210004000000", "22000008");
    refuse(&mut bus, "2F00210003000000", "22000008");
    bus.send("000#807F");
    refuse(&mut bus, "2F00210005000000", "30000906");
    refuse(&mut bus, "2F01210080000000", "31000906");
    write(&mut bus, "2F00210003000000");
}

#[test]
fn a_preset_is_lost_with_a_reset_unless_it_is_saved() {
    let memory = Memory::eeprom(4096);
    let (mut bus, hand) = wdga(Variant::Multiturn, memory.clone());
    bus.advance(0).expect("77F#00");
    hand.turn(1000);
    write(&mut bus, "2303600010000000");
    bus.send("000#817F").expect("77F#00");
    position(&mut bus, "E8030000");
    write(&mut bus, "2303600010000000");
    bus.send("67F#2310100173617665").expect("5FF#6010100100000000");
    let mut bus = switched_on(&hand, memory);
    bus.advance(0).expect("77F#00");
    position(&mut bus, "10000000");
    bus.send("67F#231110016C6F6164").expect("5FF#6011100100000000");
    bus.send("000#817F").expect("77F#00");
    position(&mut bus, "E8030000");
}

#[test]
fn customer_data_are_stored_as_they_are_written() {
    let memory = Memory::eeprom(4096);
    let (mut bus, hand) = wdga(Variant::Multiturn, memory.clone());
    bus.advance(0).expect("77F#00");
    bus.send("67F#4020210800000000").expect("5FF#43202108FFFFFFFF");
    write(&mut bus, "2320210811223344");
    bus.send("67F#231110016C6F6164").expect("5FF#6011100100000000");
    let mut bus = switched_on(&hand, memory);
    bus.advance(0).expect("77F#00");
    bus.send("67F#4020210800000000").expect("5FF#4320210811223344");
}

/// Turns the shaft by `steps` in each of `millis` ms.
fn spin(bus: &mut WdgaBus<Memory>, hand: &Hand, steps: i64, millis: u32) {
    for _ in 0..millis {
        hand.turn(steps);
        bus.advance(1);
    }
}

/// The INTEGER16 at `object` of node 127 (index, low byte first, and sub-index).
#[track_caller]
fn word(bus: &mut WdgaBus<Memory>, object: &str, bytes: &str) {
    bus.send(&format!("67F#40{object}00000000"))
        .expect(&format!("5FF#4B{object}{bytes}0000"));
}

/// The UNSIGNED8 at `object`.
#[track_caller]
fn byte(bus: &mut WdgaBus<Memory>, object: &str, byte: &str) {
    bus.send(&format!("67F#40{object}00000000"))
        .expect(&format!("5FF#4F{object}{byte}000000"));
}

#[test]
fn speed_acceleration_and_jerk_are_those_of_the_last_integration_time() {
    let (mut bus, hand) = booted();
    spin(&mut bus, &hand, 10, 1000);
    word(&mut bus, "306001", "1027"); // 10 000 steps a second
    word(&mut bus, "406001", "1027"); // in one second, from rest
    word(&mut bus, "506001", "1027");
    spin(&mut bus, &hand, 10, 1000);
    word(&mut bus, "306001", "1027");
    word(&mut bus, "406001", "0000");
    word(&mut bus, "506001", "F0D8");
    // Chapter 8.9: a shorter integration time, and backwards.
    write(&mut bus, "2305210264000000");
    spin(&mut bus, &hand, -2, 200);
    word(&mut bus, "306001", "30F8");
}

#[test]
fn a_speed_is_scaled_by_2106h_and_never_beyond_16_bits() {
    let (mut bus, hand) = booted();
    write(&mut bus, "2B06210106000000");
    write(&mut bus, "2B0621027D000000");
    // 2500 revolutions a minute are 682 667 steps a second, and 6/125 of that just beyond 32 767.
    spin(&mut bus, &hand, 683, 1000);
    word(&mut bus, "306001", "FF7F");
    spin(&mut bus, &hand, -341, 1000);
    word(&mut bus, "306001", "10C0"); // -341 000 · 6/125 = -16 368
}

#[test]
fn faster_than_the_frequency_limit_is_a_warning_without_a_message() {
    let (mut bus, hand) = booted();
    // 42 revolutions a second, the manual's example, are 688 128 steps.
    write(&mut bus, "2B0721002A000000");
    spin(&mut bus, &hand, 688, 1001);
    word(&mut bus, "056500", "0000");
    spin(&mut bus, &hand, 689, 1001);
    word(&mut bus, "056500", "0100");
    bus.silence();
    spin(&mut bus, &hand, 0, 1001);
    word(&mut bus, "056500", "0000");
    word(&mut bus, "042501", "0100");
}

#[test]
fn a_filter_makes_the_position_follow_more_slowly_and_ends_where_the_shaft_is() {
    let (mut bus, hand) = booted();
    write(&mut bus, "2F05210104000000");
    hand.turn(800);
    position(&mut bus, "64000000"); // an eighth of the way
    bus.advance(200);
    position(&mut bus, "20030000");
    refuse(&mut bus, "2F05210105000000", "31000906");
}

#[test]
fn the_cams_of_table_8_67_switch_where_it_says() {
    let (mut bus, hand) = booted();
    write(&mut bus, "2301600000100000");
    write(&mut bus, "2302600000100000");
    for request in [
        "2F01630107000000", // table 8.68
        "2320630100080000", // tables 8.69 to 8.71
        "23216301FF0F0000",
        "23226301AA020000",
        "2310630100000000", // tables 8.72 to 8.74
        "2311630101080000",
        "2312630100000000",
    ] {
        write(&mut bus, request);
    }
    let mut at = 0;
    for (position, cams) in [
        (0, "05"),
        (682, "05"),
        (683, "01"),
        (2048, "01"),
        (2049, "02"),
        (4095, "02"),
        (4096, "05"),
    ] {
        hand.turn(4 * (position - at));
        at = position;
        byte(&mut bus, "006301", cams);
    }
    // Table 7.16: cams 1, 2 and 5 inverted; the fifth is not enabled.
    write(&mut bus, "2F02630113000000");
    bus.advance(1);
    byte(&mut bus, "006301", "06");
}

#[test]
fn the_work_area_tells_on_which_side_the_position_is_outside() {
    let (mut bus, hand) = booted();
    byte(&mut bus, "006401", "00");
    hand.turn(0x4000);
    byte(&mut bus, "006401", "00");
    hand.turn(1);
    byte(&mut bus, "006401", "03");
    write(&mut bus, "2302640100000100");
    write(&mut bus, "2301640100500000");
    bus.advance(1);
    byte(&mut bus, "006401", "05");
}

#[test]
fn a_temperature_beyond_its_limits_is_a_warning_a_message_and_a_memory() {
    let memory = Memory::eeprom(8192);
    let (mut bus, hand) = wdga(Variant::Multiturn, memory.clone());
    bus.advance(0).expect("77F#00");
    word(&mut bus, "002501", "1400");
    hand.warm(Some(101));
    bus.advance(59_998).silence();
    bus.advance(2).expect("0FF#0042091000000000").silence();
    bus.send("67F#4001100000000000").expect("5FF#4F01100009000000");
    word(&mut bus, "056500", "0010");
    word(&mut bus, "002504", "6500");
    word(&mut bus, "002505", "1400");
    // It is told once, and when it is over.
    bus.advance(60_000).silence();
    hand.warm(Some(99));
    bus.advance(60_000).expect("0FF#0000000000000000").silence();
    // Limits that are tightened count at once.
    write(&mut bus, "2B00250363000000");
    bus.advance(1).silence();
    write(&mut bus, "2B00250364000000");
    bus.advance(1).expect("0FF#0042092000000000");
    hand.warm(None);
    bus.advance(60_000)
        .expect("0FF#0000000000000000")
        .expect("0FF#0042094000000000");
    word(&mut bus, "056500", "0040");
    refuse(&mut bus, "2B00250265000000", "31000906");
    refuse(&mut bus, "2B002503D7FF0000", "32000906");

    // 2502h and 2504h, the newest first; no restore forgets them.
    bus.send("67F#231110016C6F6164").expect("5FF#6011100100000000");
    hand.warm(Some(20));
    let mut bus = switched_on(&hand, memory);
    bus.advance(0).expect("77F#00");
    for (sub, error) in [
        ("01", "00424000"),
        ("02", "00422000"),
        ("03", "00421000"),
        ("04", "00000000"),
    ] {
        bus.send(&format!("67F#400225{sub}00000000"))
            .expect(&format!("5FF#430225{sub}{error}"));
    }
    for (object, warning) in [
        ("042501", "0040"),
        ("042502", "0020"),
        ("042503", "0010"),
        ("042504", "0000"),
    ] {
        word(&mut bus, object, warning);
    }
    // A client may empty the history of warnings.
    refuse(&mut bus, "2F04250001000000", "30000906");
    write(&mut bus, "2F04250000000000");
    word(&mut bus, "042501", "0000");
}

#[test]
fn a_position_error_is_an_alarm_and_does_to_the_nmt_state_what_1029h_says() {
    for (behaviour, state) in [("00", "7F"), ("01", "05"), ("02", "04")] {
        let (mut bus, hand) = booted();
        write(&mut bus, &format!("2F291002{behaviour}000000"));
        write(&mut bus, "2B17100064000000");
        bus.expect("77F#7F");
        bus.send("000#017F");
        hand.break_down(Faults::SINGLE_TURN);
        bus.advance(100).expect(&format!("77F#{state}")).silence();
        if behaviour != "02" {
            word(&mut bus, "036500", "0100");
            word(&mut bus, "032501", "0100");
            bus.send("67F#4002100000000000").expect("5FF#4302100001010000");
        }
    }
}

#[test]
fn an_eeprom_that_fails_is_told_until_it_works_again() {
    let memory = Memory::eeprom(4096);
    let (mut bus, _) = wdga(Variant::Multiturn, memory.clone());
    bus.advance(0).expect("77F#00");
    memory.fail_after(0);
    bus.send("67F#2320210111223344");
    bus.expect("0FF#0050010008000000").expect("5FF#6020210100000000");
    bus.advance(5).silence();
    bus.send("67F#4002100000000000").expect("5FF#4302100004000000");
    memory.power_on();
    bus.send("67F#2320210111223344");
    bus.expect("0FF#0000000000000000").expect("5FF#6020210100000000");
}

#[test]
fn the_five_combinations_of_table_8_46() {
    let turned = |transmission_type: &str, timer: &str, steps: i64| {
        let (mut bus, hand) = booted();
        write(&mut bus, &format!("2F001802{transmission_type}000000"));
        write(&mut bus, &format!("2B001805{timer}000000"));
        bus.send("000#017F").advance(0);
        while bus.take().is_some() {}
        hand.turn(steps);
        bus.advance(35);
        let mut sent = 0;
        while bus.take().is_some() {
            sent += 1;
        }
        sent
    };
    assert_eq!(turned("01", "1E", 1), 0, "on a SYNC only");
    assert_eq!(turned("FF", "00", 1), 0, "disabled");
    assert_eq!(turned("FE", "1E", 1), 2, "by the change and by the timer");
    assert_eq!(turned("FE", "1E", 0), 1, "by the timer alone");
    assert_eq!(turned("FE", "00", 1), 1, "by the change");
    assert_eq!(turned("FF", "1E", 1), 1, "by the timer");
}

#[test]
fn pdos_and_cams_are_configured_in_preoperational_only() {
    let (mut bus, _) = booted();
    // The mapping of a PDO that is valid is refused in any state.
    write(&mut bus, "23011801FF0200C0");
    write(&mut bus, "2F011A0000000000");
    bus.send("000#017F");
    for request in [
        "23001801FF0100C0",
        "2F03180201000000",
        "2B0118050A000000",
        "2F011A0000000000",
        "23011A0120000460",
        "2F01630101000000",
        "2F02630101000000",
        "2310630101000000",
        "2327630101000000",
        "2333630101000000",
    ] {
        refuse(&mut bus, request, "22000008");
    }
}

#[test]
fn only_a_32_bit_device_has_a_full_range() {
    // 14 bits of a revolution, 12 bits of revolutions.
    let shaft = Shaft::new(1 << 14, 1 << 12).expect("a shaft");
    let mut bus = switched_on(&Hand::new(shaft), Memory::eeprom(4096));
    bus.advance(0).expect("77F#00");
    bus.send("67F#4002600000000000").expect("5FF#4302600000000004");
    refuse(&mut bus, "2302600000000000", "32000906");
    write(&mut bus, "23026000FFFFFFFF");
}

#[test]
fn the_controller_returns_to_the_bus_after_the_seconds_of_2103h() {
    let (mut bus, _) = booted();
    let off = Instant::from_millis(1000);
    let after = |millis: u64| Instant::from_millis(1000 + millis);
    bus.slave().set_bus_state(off, BusState::Off);
    assert!(!bus.slave().is_to_rejoin(after(1_000_000)), "0 means never");
    bus.slave().set_bus_state(after(0), BusState::Active);
    bus.advance(1)
        .expect("0FF#4081110000000000")
        .expect("0FF#0000000000000000");
    write(&mut bus, "2F03210002000000");
    bus.slave().set_bus_state(off, BusState::Off);
    bus.slave().set_bus_state(after(500), BusState::Off);
    assert!(!bus.slave().is_to_rejoin(after(1999)));
    assert!(bus.slave().is_to_rejoin(after(2000)));
    bus.slave().set_bus_state(after(2000), BusState::Active);
    assert!(!bus.slave().is_to_rejoin(after(3000)));
}
