//! The virtual WDGA, as a client on its bus sees it: what the manual says of its objects and its behaviour.

use lexican_runtime::storage::NoStorage;
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
    let now = lexican_runtime::Instant::from_millis(1);
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
