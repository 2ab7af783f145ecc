//! Multiplexed PDOs (CiA 301, 7.2.2.4): a PDO that says itself which object it carries.

use lexican_runtime::{Address, NodeId};
use lexican_tests::{
    bus::Bus,
    generated::multiplexed::Device,
    network::{refuse, set},
};

const POSITION: Address = Address::new(0x6004, 0);

/// Node 1, OPERATIONAL, of `tests/fixtures/codegen/multiplexed.eds`. TPDO 1 (181h) is addressed at the sender, which scans 6004h and
/// 2100h:01 to 03; TPDO 2 (281h) at the receiver. RPDO 1 (201h) takes what node 7 says of its 6004h into 6200h, and of its 2100h:01
/// and 02 into 2200h:05 and 06; RPDO 2 (301h) is addressed at the receiver.
fn bus() -> Bus<Device<()>> {
    let mut bus = Bus::booted(Device::new(()), 1);
    bus.send("000#0101").silence();
    bus
}

/// What a client reads, as it stands in the response.
fn read(bus: &mut Bus<Device<()>>, index: u16, sub: u8) -> String {
    let [low, high] = index.to_le_bytes();
    bus.send(&format!("601#40{low:02X}{high:02X}{sub:02X}00000000"));
    let answer = bus.take().map(|frame| format!("{frame:?}")).unwrap_or_default();
    answer[12..].to_owned()
}

#[test]
fn a_change_of_a_scanned_object_is_sent_with_its_address_and_the_senders_node() {
    let mut bus = bus();
    assert!(bus.node().object_changed(POSITION));
    bus.advance(0).expect("181#0104600044332211").silence();
    assert!(bus.node().object_changed(Address::new(0x2100, 3)));
    bus.advance(0).expect("181#01002103A3A30000").silence();
    assert!(
        !bus.node().object_changed(Address::new(0x2100, 4)),
        "the block ends before it"
    );
    assert!(
        !bus.node().object_changed(Address::new(0x2100, 2)),
        "there is no such object"
    );
    bus.advance(0).silence();
}

#[test]
fn a_value_is_sent_to_an_object_of_one_node_or_of_all() {
    let mut bus = bus();
    let there = Address::new(0x6411, 2);
    assert!(bus.node().send_multiplexed(NodeId::new(0x22), there, 0x1234));
    bus.advance(0).expect("281#A211640234120000").silence();
    assert!(bus.node().send_multiplexed(None, there, 0xFFFF_FFFF));
    assert!(
        !bus.node().send_multiplexed(None, there, 0),
        "the one before it still waits"
    );
    bus.advance(0).expect("281#80116402FFFFFFFF").silence();
    bus.send("000#8001");
    assert!(!bus.node().send_multiplexed(None, there, 1), "not OPERATIONAL");
}

#[test]
fn nothing_but_a_value_sends_a_multiplexed_pdo() {
    let mut bus = bus();
    assert!(!bus.node().trigger_tpdo(1));
    bus.send("080#").send("181#R8").advance(10_000).silence();
}

#[test]
fn what_another_node_says_of_its_objects_goes_where_the_dispatching_list_says() {
    let mut bus = bus();
    bus.send("201#0704600078563412").silence();
    assert_eq!(read(&mut bus, 0x6200, 0), "78563412");
    bus.send("201#0700210255000000").silence();
    assert_eq!(read(&mut bus, 0x2200, 6), "55000000");
    for not_listed in [
        "201#0804600001000000",
        "201#0700210355000000",
        "201#8704600001000000",
        "201#07046000010000",
    ] {
        bus.send(not_listed).silence();
    }
    assert_eq!(read(&mut bus, 0x6200, 0), "78563412");
    assert_eq!(read(&mut bus, 0x2200, 5), "00000000");
}

#[test]
fn what_is_addressed_to_this_node_or_to_all_goes_into_the_object_that_it_names() {
    let mut bus = bus();
    bus.send("301#8100620078563412").silence();
    assert_eq!(read(&mut bus, 0x6200, 0), "78563412");
    bus.send("301#8000220566000000").silence();
    assert_eq!(read(&mut bus, 0x2200, 5), "66000000");
    for of_others in [
        "301#8200620000000000",
        "301#0100620000000000",
        "301#8100230099000000",
        "301#8100990000000000",
    ] {
        bus.send(of_others).silence();
    }
    assert_eq!(read(&mut bus, 0x6200, 0), "78563412");
    assert_eq!(read(&mut bus, 0x2300, 0), "23000000");
}

#[test]
fn a_mapping_becomes_multiplexed_as_it_changes_otherwise() {
    let mut bus = bus();
    refuse(&mut bus, (0x1A00, 0), &[0xFF], 0x0601_0000);
    set(&mut bus, 0x1800, 1, &[0x81, 0x01, 0, 0x80]);
    set(&mut bus, 0x1A00, 0, &[0]);
    refuse(&mut bus, (0x1A00, 0), &[0xFD], 0x0604_0042);
    set(&mut bus, 0x1A00, 0, &[0xFF]);
    set(&mut bus, 0x1800, 1, &[0x81, 0x01, 0, 0]);
    assert!(bus.node().send_multiplexed(None, POSITION, 1));
    bus.advance(0).expect("181#8004600001000000");
}
