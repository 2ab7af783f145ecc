//! LSS and 5F0Ah, which set the same node-ID and the same bit rate (5.6, 5.7.2.26).

use crate::device::{Client, delivered, eeprom, shaft, switched_on};
use lexican_runtime::lss::BitRate;
use lexican_wv58mr::Variant;

const TO_CONFIGURATION: &str = "7E5#0401000000000000";
const TO_WAITING: &str = "7E5#0400000000000000";
const STORE: &str = "7E5#1700000000000000";
const STORED: &str = "7E4#1700000000000000";

#[test]
fn a_node_id_that_lss_sets_counts_after_a_reset_of_communication_and_outlives_power_off_once_stored() {
    let (shaft, cells) = (shaft(Variant::MultiTurn12), eeprom());
    let mut bus = switched_on(&shaft, &cells);
    bus.advance(0).expect("701#00");
    bus.send(TO_CONFIGURATION)
        .send("7E5#1105000000000000")
        .expect("7E4#1100000000000000");
    bus.send(TO_WAITING).send("000#8201").expect("705#00");
    assert_eq!(bus.get(0x5F0A, 1), 5);
    assert_eq!(
        [bus.get(0x1800, 1), bus.get(0x1014, 0), bus.get(0x1200, 1)],
        [0x185, 0x85, 0x605]
    );
    switched_on(&shaft, &cells).advance(0).expect("701#00");

    bus.send(TO_CONFIGURATION).send(STORE).expect(STORED);
    switched_on(&shaft, &cells).advance(0).expect("705#00");
}

#[test]
fn a_node_id_in_5f0ah_counts_after_a_reset_and_is_saved_with_the_parameters() {
    let (shaft, cells) = (shaft(Variant::MultiTurn12), eeprom());
    let mut bus = switched_on(&shaft, &cells);
    bus.advance(0).expect("701#00");
    bus.refuse(0x5F0A, 1, &[0], 0x0609_0032)
        .refuse(0x5F0A, 1, &[128], 0x0609_0031)
        .set(0x5F0A, 1, &[9]);
    assert_eq!(bus.get(0x5F0A, 1), 9);
    // Not saved: a reset of the node forgets it.
    bus.send("000#8101").expect("701#00");
    assert_eq!(bus.get(0x5F0A, 1), 1);
    bus.set(0x5F0A, 1, &[9]).send("000#8201").expect("709#00");
    switched_on(&shaft, &cells).advance(0).expect("701#00");

    for group in [1, 4] {
        let mut bus = switched_on(&shaft, &eeprom());
        bus.advance(0).expect("701#00");
        bus.set(0x5F0A, 1, &[9]).set(0x1010, group, b"save");
        bus.send("000#8101").expect("709#00");
    }
}

#[test]
fn the_baud_rate_in_5f0ah_counts_after_a_reset() {
    let (mut bus, _) = delivered();
    assert_eq!(bus.get(0x5F0A, 2), 5);
    assert_eq!(bus.slave().0.bit_rate(), BitRate::KBIT_500);
    bus.refuse(0x5F0A, 2, &[0], 0x0609_0032)
        .refuse(0x5F0A, 2, &[8], 0x0609_0031);
    for (number, rate) in (1..).zip([20, 50, 125, 250, 500, 800, 1000]) {
        let before = bus.slave().0.bit_rate();
        bus.set(0x5F0A, 2, &[number]);
        assert_eq!(bus.slave().0.bit_rate(), before);
        bus.send("000#8201").expect("701#00");
        assert_eq!(bus.slave().0.bit_rate().kbit_per_s(), Some(rate));
        assert_eq!(bus.get(0x5F0A, 2), u32::from(number));
    }
}

#[test]
fn a_bit_rate_is_activated_after_the_first_delay_and_the_encoder_is_silent_for_both() {
    let (mut bus, _) = delivered();
    bus.set(0x1017, 0, &[10, 0]).advance(0).expect("701#7F");
    bus.send(TO_CONFIGURATION)
        .send("7E5#1300030000000000")
        .expect("7E4#1300000000000000");
    assert_eq!(bus.get(0x5F0A, 2), 4);
    bus.send("7E5#1564000000000000").advance(99).silence();
    assert_eq!(bus.slave().0.bit_rate(), BitRate::KBIT_500);
    bus.advance(1).silence();
    assert_eq!(bus.slave().0.bit_rate(), BitRate::KBIT_250);
    bus.advance(99).silence();
    bus.advance(1).expect("701#7F");
}

#[test]
fn the_serial_number_is_inquired_as_1018h_has_it() {
    let (mut bus, _) = delivered();
    bus.send(TO_CONFIGURATION)
        .send("7E5#5D00000000000000")
        .expect("7E4#5D01000000000000");
    assert_eq!(bus.get(0x1018, 4), 1);
}
