//! LSS (CiA 305), as a master sees it.

use lexican_runtime::{
    Event, Node, NodeId,
    lss::{BitRate, State},
};
use lexican_tests::{
    bus::Bus,
    simulated::{Object, Simulated},
};

/// Vendor-ID 13Fh, product code 5744h, revision number 0001 0002h, serial number BEEF 0001h.
fn device() -> Simulated {
    let identity = [4, 0x13F, 0x5744, 0x0001_0002, 0xBEEF_0001];
    let subs = (0..).zip(identity);
    let mut objects: Vec<Object> = subs
        .map(|(sub, value)| Object::number(0x1018, sub, if sub == 0 { 1 } else { 4 }, value))
        .collect();
    objects.push(Object::number(0x1017, 0, 2, 0));
    objects.push(Object::number(0x6004, 0, 4, 0x1122_3344));
    Simulated::new(&objects)
}

fn configured() -> Bus<Simulated> {
    Bus::booted(device(), 4)
}

fn unconfigured() -> Bus<Simulated> {
    Bus::of(Node::unconfigured(device()))
}

const TO_WAITING: &str = "7E5#0400000000000000";
const TO_CONFIGURATION: &str = "7E5#0401000000000000";
const INQUIRE_NODE_ID: &str = "7E5#5E00000000000000";

fn select(bus: &mut Bus<Simulated>) -> &mut Bus<Simulated> {
    bus.send("7E5#403F010000000000")
        .send("7E5#4144570000000000")
        .send("7E5#4202000100000000")
        .silence();
    bus.send("7E5#430100EFBE000000")
}

#[test]
fn all_slaves_are_switched_without_an_answer() {
    let mut bus = configured();
    assert_eq!(bus.node().lss_state(), State::Waiting);
    bus.send(INQUIRE_NODE_ID).silence();
    bus.send(TO_CONFIGURATION).silence();
    assert_eq!(bus.node().lss_state(), State::Configuration);
    bus.send(INQUIRE_NODE_ID).expect("7E4#5E04000000000000").silence();
    bus.send("7E5#0402000000000000").silence();
    bus.send(INQUIRE_NODE_ID).expect("7E4#5E04000000000000");
    bus.send(TO_WAITING).send(INQUIRE_NODE_ID).silence();
}

#[test]
fn the_slave_with_the_lss_address_is_selected() {
    let mut bus = configured();
    select(&mut bus).expect("7E4#4400000000000000").silence();
    assert_eq!(bus.node().lss_state(), State::Configuration);
    // In configuration state the service is none.
    select(&mut bus).silence();
}

#[test]
fn a_selection_needs_all_four_messages_in_their_order() {
    let vendor = "7E5#403F010000000000";
    let product = "7E5#4144570000000000";
    let revision = "7E5#4202000100000000";
    let serial = "7E5#430100EFBE000000";
    for messages in [
        &[serial][..],
        &[vendor, product, serial],
        &[vendor, revision, product, serial],
        &[vendor, product, revision, revision, serial],
        &["7E5#403E010000000000", product, revision, serial],
        &[vendor, product, revision, "7E5#430200EFBE000000", serial],
    ] {
        let mut bus = configured();
        for message in messages {
            bus.send(message).silence();
        }
        assert_eq!(bus.node().lss_state(), State::Waiting, "{messages:?}");
    }
    let mut bus = configured();
    bus.send(vendor).send(product).send(vendor).send(product);
    bus.send("701#05").send(revision).send(serial).expect("7E4#44..");
}

#[test]
fn short_and_remote_frames_and_unknown_services_are_ignored() {
    let mut bus = configured();
    for frame in [
        "7E5#0401",
        "7E5#04010000000000",
        "7E5#R8",
        "7E4#0401000000000000",
        "000007E5#0401000000000000",
    ] {
        bus.send(frame).send(INQUIRE_NODE_ID).silence();
    }
    bus.send(TO_CONFIGURATION).send("7E5#9900000000000000").silence();
}

#[test]
fn the_lss_address_is_told_in_configuration_state() {
    let mut bus = configured();
    bus.send("7E5#5A00000000000000").silence();
    bus.send(TO_CONFIGURATION);
    bus.send("7E5#5A00000000000000").expect("7E4#5A3F010000000000");
    bus.send("7E5#5B00000000000000").expect("7E4#5B44570000000000");
    bus.send("7E5#5C00000000000000").expect("7E4#5C02000100000000");
    bus.send("7E5#5D00000000000000").expect("7E4#5D0100EFBE000000");
    bus.silence();
}

#[test]
fn a_node_id_is_pending_until_communication_is_reset() {
    let mut bus = configured();
    bus.send(TO_CONFIGURATION)
        .send("7E5#1155000000000000")
        .expect("7E4#1100000000000000");
    bus.send(INQUIRE_NODE_ID).expect("7E4#5E04000000000000");
    bus.send("604#4004600000000000").expect("584#43..");
    bus.send(TO_WAITING).send("000#8204").expect("755#00").silence();
    assert_eq!(bus.node().node_id(), NodeId::new(0x55));
    bus.send("655#4004600000000000").expect("5D5#4304600044332211");
    bus.send("604#4004600000000000").silence();
}

#[test]
fn reset_node_goes_back_to_the_node_id_of_power_on() {
    let mut bus = configured();
    bus.send(TO_CONFIGURATION)
        .send("7E5#1155000000000000")
        .expect("7E4#11..");
    bus.send("000#8200").expect("755#00").silence();
    assert_eq!(bus.node().lss_state(), State::Waiting);
    bus.send("000#8100").expect("704#00").silence();
}

#[test]
fn a_number_that_is_no_node_id_is_refused() {
    let mut bus = configured();
    bus.send(TO_CONFIGURATION);
    for number in [0, 128, 129, 254] {
        bus.send(&format!("7E5#11{number:02X}000000000000"))
            .expect("7E4#1101000000000000");
    }
    for number in [1, 127, 255] {
        bus.send(&format!("7E5#11{number:02X}000000000000"))
            .expect("7E4#1100000000000000");
    }
}

#[test]
fn a_bit_rate_is_one_of_the_table_that_the_device_supports() {
    let mut bus = configured();
    bus.send(TO_CONFIGURATION);
    for index in [0, 1, 2, 3, 4, 6, 7, 8] {
        bus.send(&format!("7E5#1300{index:02X}0000000000"))
            .expect("7E4#1300000000000000");
    }
    for (table, index) in [(0, 5), (0, 9), (0, 10), (0, 255), (1, 0), (0x80, 2)] {
        bus.send(&format!("7E5#13{table:02X}{index:02X}0000000000"))
            .expect("7E4#1301000000000000");
    }
    let mut bus = Bus::booted(device().with_bit_rates(0x0004), 4);
    bus.send(TO_CONFIGURATION);
    bus.send("7E5#1300020000000000").expect("7E4#1300000000000000");
    bus.send("7E5#1300030000000000").expect("7E4#1301000000000000");
}

#[test]
fn a_bit_rate_is_activated_between_two_delays_without_a_frame() {
    let mut bus = configured();
    bus.send("604#2B17100064000000").expect("584#60..");
    bus.expect("704#7F");
    bus.send(TO_CONFIGURATION)
        .send("7E5#1300030000000000")
        .expect("7E4#13..");
    assert_eq!(bus.node().bit_rate(), None);
    // 500 ms
    bus.send("7E5#15F4010000000000").silence();
    bus.advance(499).silence();
    assert_eq!(bus.node().bit_rate(), None);
    bus.advance(1).silence();
    assert_eq!(bus.node().bit_rate(), Some(BitRate::KBIT_250));
    bus.send(INQUIRE_NODE_ID).silence();
    bus.advance(499).silence();
    bus.advance(1).expect("704#7F").expect("7E4#5E04000000000000").silence();
    bus.advance(100).expect("704#7F").silence();
    let told = bus.node().device().told().iter();
    let told: Vec<_> = told.filter(|event| matches!(event, Event::BitRate(_))).collect();
    assert_eq!(told, [&Event::BitRate(BitRate::KBIT_250)]);
}

#[test]
fn without_delays_a_bit_rate_is_activated_at_once_and_nothing_more_is_due() {
    let mut bus = configured();
    bus.send(TO_CONFIGURATION)
        .send("7E5#1300030000000000")
        .expect("7E4#13..");
    bus.send("7E5#1500000000000000").silence();
    assert_eq!(bus.node().bit_rate(), Some(BitRate::KBIT_250));
    assert_eq!(bus.node().poll_at(), None, "nothing is said twice");
    bus.send(INQUIRE_NODE_ID).expect("7E4#5E04000000000000").silence();
}

#[test]
fn a_node_that_lost_its_node_id_meanwhile_answers_when_the_bit_rate_is_switched() {
    let mut bus = configured();
    bus.send(TO_CONFIGURATION)
        .send("7E5#150A000000000000")
        .send("7E5#11FF000000000000")
        .send("000#8200")
        .send(TO_CONFIGURATION)
        .send("7E5#1300090000000000")
        .silence();
    bus.advance(20).expect("7E4#13..").silence();
    assert_eq!(bus.node().poll_at(), None);
}

#[test]
fn the_application_s_reset_does_not_break_the_silence() {
    let mut bus = configured();
    bus.send(TO_CONFIGURATION)
        .send("7E5#1300030000000000")
        .expect("7E4#13..");
    bus.send("7E5#150A000000000000");
    bus.node().set_node_id(NodeId::new(5).unwrap());
    bus.advance(19).silence();
    bus.advance(1).expect("705#00").silence();
}

#[test]
fn a_device_without_storage_cannot_store() {
    let mut bus = configured();
    bus.send("7E5#1700000000000000").silence();
    bus.send(TO_CONFIGURATION)
        .send("7E5#1700000000000000")
        .expect("7E4#1701000000000000");
}

#[test]
fn slaves_within_the_bounds_are_identified_in_either_state() {
    let identify = |bus: &mut Bus<Simulated>, bounds: [u32; 6]| {
        for (command, bound) in (0x46..).zip(bounds) {
            bus.silence();
            let [b0, b1, b2, b3] = bound.to_le_bytes();
            bus.send(&format!("7E5#{command:02X}{b0:02X}{b1:02X}{b2:02X}{b3:02X}000000"));
        }
        bus.take().map(|frame| format!("{frame:?}"))
    };
    let right = [0x13F, 0x5744, 0x0001_0000, 0x0001_FFFF, 0, u32::MAX];
    let exact = [0x13F, 0x5744, 0x0001_0002, 0x0001_0002, 0xBEEF_0001, 0xBEEF_0001];
    let identified = Some("7E4#4F00000000000000".to_owned());
    let mut bus = configured();
    assert_eq!(identify(&mut bus, right), identified);
    assert_eq!(identify(&mut bus, exact), identified);
    bus.send(TO_CONFIGURATION);
    assert_eq!(identify(&mut bus, exact), identified);
    for (number, wrong) in (0..).zip([0x140, 0x5745, 0x0001_0003, 0x0001_0001, 0xBEEF_0002, 0xBEEF_0000]) {
        let mut bounds = exact;
        bounds[number] = wrong;
        assert_eq!(identify(&mut bus, bounds), None, "{bounds:08X?}");
    }
}

#[test]
fn a_node_without_a_node_id_takes_lss_messages_only() {
    let mut bus = unconfigured();
    bus.advance(10_000).silence();
    assert_eq!(bus.node().node_id(), None);
    assert_eq!(bus.node().poll_at(), None);
    bus.node().device_mut();
    for frame in [
        "000#0100",
        "000#8200",
        "000#8100",
        "6FF#4018100100000000",
        "7FF#R1",
        "080#",
    ] {
        bus.send(frame).advance(1000).silence();
    }
    bus.send("7E5#4C00000000000000")
        .expect("7E4#5000000000000000")
        .silence();
    select(&mut bus).expect("7E4#44..");
    bus.send(INQUIRE_NODE_ID).expect("7E4#5EFF000000000000");
    bus.send("7E5#1155000000000000").expect("7E4#1100000000000000");
    bus.send("7E5#4C00000000000000").silence();
    bus.send(TO_WAITING).expect("755#00").silence();
    assert_eq!(bus.node().node_id(), NodeId::new(0x55));
    bus.send("655#4004600000000000").expect("5D5#43..");
}

#[test]
fn a_node_loses_its_node_id_when_255_is_configured() {
    let mut bus = configured();
    bus.send("7E5#4C00000000000000").silence();
    bus.send(TO_CONFIGURATION)
        .send("7E5#11FF000000000000")
        .expect("7E4#11..");
    bus.send(TO_WAITING).send("7E5#4C00000000000000").silence();
    bus.send("000#8204").silence();
    assert_eq!(bus.node().node_id(), None);
    bus.send("7E5#4C00000000000000")
        .expect("7E4#5000000000000000")
        .silence();
    // As at power-on.
    bus.send("000#8100").expect("704#00");
}

/// Asks bit by bit, as CiA 305 has it; gives the LSS address that was found.
fn fast_scan(bus: &mut Bus<Simulated>) -> Option<[u32; 4]> {
    let mut ask = |id_number: u32, bit_check: u8, sub: usize, next: usize| {
        let [b0, b1, b2, b3] = id_number.to_le_bytes();
        bus.send(&format!(
            "7E5#51{b0:02X}{b1:02X}{b2:02X}{b3:02X}{bit_check:02X}{sub:02X}{next:02X}"
        ));
        let answer = bus.take().map(|frame| format!("{frame:?}"));
        assert!(answer.is_none() || answer.as_deref() == Some("7E4#4F00000000000000"));
        answer.is_some()
    };
    let mut found = [0; 4];
    if !ask(0, 128, 0, 0) {
        return None;
    }
    for (sub, part) in found.iter_mut().enumerate() {
        for bit in (0..32).rev() {
            if !ask(*part, bit, sub, sub) {
                *part |= 1 << bit;
            }
        }
        assert!(ask(*part, 0, sub, (sub + 1) % 4));
    }
    Some(found)
}

#[test]
fn a_fastscan_finds_the_lss_address_and_selects_the_slave() {
    let mut bus = unconfigured();
    assert_eq!(fast_scan(&mut bus), Some([0x13F, 0x5744, 0x0001_0002, 0xBEEF_0001]));
    assert_eq!(bus.node().lss_state(), State::Configuration);
    // It has been found, and leaves the next scan to others.
    assert_eq!(fast_scan(&mut bus), None);
    bus.send("7E5#1107000000000000").expect("7E4#11..");
    bus.send(TO_WAITING).expect("707#00").silence();
    assert_eq!(fast_scan(&mut bus), None);
}

#[test]
fn a_fastscan_goes_part_by_part() {
    let mut bus = unconfigured();
    let question =
        |number: &str, bit_check: &str, sub: &str, next: &str| format!("7E5#51{number}{bit_check}{sub}{next}");
    // Not started with the vendor-ID; bits, parts and next parts that are none.
    for (bit_check, sub, next) in [
        ("00", "01", "01"),
        ("20", "00", "00"),
        ("7F", "00", "00"),
        ("00", "04", "00"),
        ("00", "00", "04"),
    ] {
        bus.send(&question("3F010000", bit_check, sub, next)).silence();
    }
    bus.send(&question("3F010000", "00", "00", "01")).expect("7E4#4F..");
    bus.send(&question("3F010000", "00", "00", "01")).silence();
    bus.send(&question("45570000", "00", "01", "02")).silence();
    bus.send(&question("45570000", "01", "01", "01")).expect("7E4#4F..");
    // A new start begins with the vendor-ID again.
    bus.send(&question("00000000", "80", "00", "00")).expect("7E4#4F..");
    bus.send(&question("3F010000", "00", "00", "01"))
        .expect("7E4#4F..")
        .silence();
}

#[test]
fn lss_is_served_in_every_nmt_state() {
    for command in ["01", "02", "80"] {
        let mut bus = configured();
        bus.send(&format!("000#{command}04")).silence();
        select(&mut bus).expect("7E4#4400000000000000");
        bus.send(INQUIRE_NODE_ID).expect("7E4#5E04000000000000");
    }
}

#[test]
fn a_bit_rate_has_the_speed_of_its_row_in_the_table_of_the_standard() {
    // CiA 305: row 5 is reserved, row 9 is automatic detection.
    let table = [
        Some(1000),
        Some(800),
        Some(500),
        Some(250),
        Some(125),
        None,
        Some(50),
        Some(20),
        Some(10),
        None,
    ];
    for (index, expected) in (0..).zip(table) {
        let bit_rate = BitRate::from_index(index);
        assert_eq!(bit_rate.and_then(BitRate::kbit_per_s), expected, "row {index}");
        assert_eq!(bit_rate.map(BitRate::index), (index != 5).then_some(index));
    }
    assert_eq!(BitRate::from_index(10), None);
}
