//! Both encoders of a housing on one bus (2, 5.1, 5.7.2.15, 5.7.2.50).

use crate::device::{Bus, Client, Two, housing, shaft};
use lexican_runtime::profile::encoder::Faults;
use lexican_tests::encoder::Hand;
use lexican_wv58mr::Variant;

fn booted() -> (Bus<Two>, [Hand; 2]) {
    let shafts = [Variant::MultiTurn12; 2].map(shaft);
    let mut bus = housing(&shafts);
    bus.advance(0).expect("701#00").expect("702#00").silence();
    (bus, shafts)
}

#[test]
fn they_are_nodes_1_and_2_with_serial_numbers_of_their_own() {
    let (mut bus, _) = booted();
    // 47111 and 47112.
    bus.send("601#40181004 00000000").expect("581#43181004 07B80000");
    bus.send("602#40181004 00000000").expect("582#43181004 08B80000");
    bus.send("602#400B6500 00000000").expect("582#430B6500 08B80000");
    bus.send("602#400A5F01 00000000").expect("582#4F0A5F01 02000000");
    bus.send("602#40001801 00000000")
        .expect("582#43001801 82010000")
        .silence();
}

#[test]
fn each_has_its_own_dictionary_and_sensor() {
    let (mut bus, [first, second]) = booted();
    first.put(1000);
    second.put(2000);
    bus.set(0x6001, 0, &8192_u32.to_le_bytes()).advance(1);
    bus.send("000#0100").send("080#");
    bus.expect("281#F40100000000").expect("282#D00700000000").silence();
    second.break_down(Faults::POSITION);
    bus.advance(1).expect("082#05FF810000000000").silence();
}

#[test]
fn an_lss_master_selects_one_of_them() {
    let (mut bus, _) = booted();
    bus.send("7E5#4095010000000000")
        .send("7E5#41FFFFFFFF000000")
        .send("7E5#42FFFFFFFF000000")
        .send("7E5#4308B80000000000")
        .expect("7E4#4400000000000000")
        .silence();
    bus.send("7E5#5E00000000000000")
        .expect("7E4#5E02000000000000")
        .silence();
}

#[test]
fn a_command_to_one_leaves_the_other_alone() {
    let (mut bus, _) = booted();
    bus.send("000#0102").send("080#").expect("282#000000000000").silence();
    bus.send("000#8102").expect("702#00").silence();
    bus.send("702#R1").expect("702#7F").silence();
    bus.send("701#R1").expect("701#7F").silence();
}
