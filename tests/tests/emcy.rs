//! Emergencies (CiA 301, 7.2.7 and objects 1001h, 1003h, 1014h, 1015h).

use lexican_runtime::{Address, Emergency, NmtCommand, od::Access};
use lexican_tests::{
    bus::Bus,
    sample::quiet,
    simulated::{Object, Simulated},
};

const VOLTAGE: Emergency = Emergency::new(0x3000, 0x04).with([0xA1, 0xA2, 0xA3, 0xA4, 0xA5]);
const TEMPERATURE: Emergency = Emergency::new(0x4000, 0x08);

/// Node 1 with a history of three errors.
fn bus() -> Bus<Simulated> {
    let mut objects = vec![
        Object::number(0x1001, 0, 1, 0),
        Object::number(0x1003, 0, 1, 0),
        Object::number(0x1014, 0, 4, 0x80).with(Access::NODE_ID),
        Object::number(0x1015, 0, 2, 0),
    ];
    objects.extend((1..=3).map(|sub| Object::number(0x1003, sub, 4, 0)));
    Bus::booted(Simulated::new(&objects), 1)
}

fn raise(bus: &mut Bus<Simulated>, emergency: Emergency) -> &mut Bus<Simulated> {
    assert!(bus.node().raise_emergency(emergency));
    bus.advance(0)
}

fn clear(bus: &mut Bus<Simulated>, emergency: Emergency) -> &mut Bus<Simulated> {
    assert!(bus.node().clear_emergency(emergency.code));
    bus.advance(0)
}

#[test]
fn an_error_is_told_with_the_generic_bit_and_the_manufacturers_bytes() {
    let mut bus = bus();
    raise(&mut bus, VOLTAGE)
        .expect("081#003005A1A2A3A4A5")
        .silence()
        .send("601#4001100000000000")
        .expect("581#4F01100005000000");
}

#[test]
fn the_register_holds_what_all_standing_errors_say() {
    let mut bus = bus();
    raise(&mut bus, VOLTAGE).expect("081#003005A1A2A3A4A5");
    raise(&mut bus, TEMPERATURE).expect("081#00400D0000000000");
    clear(&mut bus, VOLTAGE).expect("081#0000090000000000");
    clear(&mut bus, TEMPERATURE).expect("081#0000000000000000");
    bus.send("601#4001100000000000").expect("581#4F01100000000000");
}

#[test]
fn an_error_that_stands_is_not_told_again() {
    let mut bus = bus();
    raise(&mut bus, VOLTAGE).expect("081#003005A1A2A3A4A5");
    assert!(!bus.node().raise_emergency(VOLTAGE));
    assert!(!bus.node().clear_emergency(TEMPERATURE.code));
    assert!(
        !bus.node().raise_emergency(Emergency::new(0x0000, 0x04)),
        "0000h is no error"
    );
    bus.advance(0).silence();
}

#[test]
fn a_ninth_error_is_refused() {
    let mut bus = bus();
    for code in 1..=8 {
        raise(&mut bus, Emergency::new(0x1000 + code, 0)).expect("081#..");
    }
    assert!(!bus.node().raise_emergency(VOLTAGE));
    clear(&mut bus, Emergency::new(0x1003, 0)).expect("081#0000010000000000");
    raise(&mut bus, VOLTAGE).expect("081#003005A1A2A3A4A5");
}

#[test]
fn the_history_has_the_newest_error_first_and_drops_the_oldest() {
    let mut bus = bus();
    for code in 1..=4 {
        raise(&mut bus, Emergency::new(0x5000 + code, 0).with([0x34, 0x12, 0, 0, 0])).expect("081#..");
    }
    bus.send("601#4003100000000000")
        .expect("581#4F03100003000000")
        .send("601#4003100100000000")
        .expect("581#4303100104503412")
        .send("601#4003100300000000")
        .expect("581#4303100302503412");
}

#[test]
fn only_zero_may_be_written_to_the_history_and_empties_it() {
    let mut bus = bus();
    raise(&mut bus, VOLTAGE)
        .expect("081#..")
        .send("601#2F03100001000000")
        .expect("581#8003100030000906")
        .send("601#4003100100000000")
        .expect("581#430310010030A1A2")
        .send("601#2F03100000000000")
        .expect("581#6003100000000000")
        .send("601#4003100000000000")
        .expect("581#4F03100000000000")
        .send("601#4003100100000000")
        .expect("581#4303100100000000");
}

#[test]
fn messages_keep_the_inhibit_time_between_them() {
    let mut bus = bus();
    bus.send("601#2B15100064000000").expect("581#6015100000000000"); // 10 ms
    raise(&mut bus, VOLTAGE).expect("081#003005A1A2A3A4A5");
    raise(&mut bus, TEMPERATURE).silence();
    clear(&mut bus, VOLTAGE)
        .silence()
        .advance(9)
        .silence()
        .advance(1)
        .expect("081#00400D0000000000")
        .silence()
        .advance(10)
        .expect("081#0000090000000000")
        .advance(100)
        .silence();
}

#[test]
fn what_happens_in_stopped_is_told_after_it() {
    let mut bus = bus();
    bus.send("000#0201");
    raise(&mut bus, VOLTAGE).advance(100).silence();
    bus.send("000#8001").expect("081#003005A1A2A3A4A5").silence();
}

#[test]
fn what_happens_before_the_boot_up_is_told_after_it() {
    let mut bus = bus();
    bus.node().obey(NmtCommand::ResetCommunication);
    assert!(bus.node().raise_emergency(VOLTAGE));
    bus.advance(0).expect("701#00").expect("081#003005A1A2A3A4A5").silence();
}

#[test]
fn a_reset_forgets_errors_and_messages() {
    let mut bus = bus();
    bus.send("000#0201");
    raise(&mut bus, VOLTAGE)
        .send("000#8101")
        .expect("701#00")
        .silence()
        .send("601#4001100000000000")
        .expect("581#4F01100000000000");
    raise(&mut bus, VOLTAGE).expect("081#003005A1A2A3A4A5");
}

#[test]
fn no_message_goes_out_while_1014h_is_not_valid() {
    let mut bus = bus();
    bus.send("601#2314100081000080").expect("581#6014100000000000");
    raise(&mut bus, VOLTAGE)
        .silence()
        .send("601#2314100081000000")
        .expect("581#6014100000000000");
    raise(&mut bus, TEMPERATURE).expect("081#00400D0000000000").silence();
}

#[test]
fn the_identifier_changes_only_while_it_is_not_valid_and_may_have_29_bits() {
    let mut bus = bus();
    bus.send("601#2314100082000000")
        .expect("581#8014100030000906")
        .send("601#2314100000000080")
        .expect("581#6014100000000000")
        .send("601#2314100001060000") // 601h is the SDO server's
        .expect("581#8014100030000906")
        .send("601#2314100081000040") // bit 30 is reserved
        .expect("581#8014100030000906")
        .send("601#2314100001A00000") // more than 11 bits
        .expect("581#8014100030000906")
        .send("601#23141000563412 20")
        .expect("581#6014100000000000");
    raise(&mut bus, VOLTAGE).expect("00123456#003005A1A2A3A4A5");
}

#[test]
fn a_device_without_the_objects_of_emcy_sends_nothing() {
    let objects = [Object::number(0x1000, 0, 4, 0)];
    let mut bus = Bus::booted(Simulated::new(&objects), 1);
    assert!(bus.node().raise_emergency(VOLTAGE));
    bus.advance(100).silence();
}

#[test]
fn the_application_sees_the_register_in_its_dictionary() {
    let mut bus = Bus::booted(quiet(), 1);
    assert!(bus.node().raise_emergency(TEMPERATURE));
    assert_eq!(bus.node().device().od.error_register, 0x09);
    assert!(bus.node().read(Address::new(0x1001, 0)).is_ok());
    bus.advance(0).expect("081#0040090000000000");
}
