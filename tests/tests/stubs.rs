//! The skeleton of an application that `lexican generate --stubs` writes compiles against its dictionary, and gives what
//! is stored.

use lexican_runtime::{Address, od};
use lexican_tests::generated::every_kind;

mod stubs {
    include!("../generated/every_kind_stubs.snap.rs");
}

#[test]
fn the_skeleton_of_an_application_answers_with_what_is_stored() {
    let mut device = every_kind::Device::new(stubs::App);
    for (index, sub, expected) in [(0x2600, 0, 0), (0x2606, 2, 1), (0x6004, 0, 7), (0x6030, 3, 9)] {
        device.od.position_value = 7;
        device.od.speed_value = [0, 0, 9];
        let value = od::read(&mut device, Address::new(index, sub)).unwrap();
        assert_eq!(value.bits(), expected, "{index:04X}");
    }
    od::write(&mut device, &mut (), Address::new(0x6003, 0), &[5, 0, 0, 0]).unwrap();
    assert_eq!(device.od.preset_value, 5);
}
