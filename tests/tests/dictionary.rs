//! The dictionary of the sample device, by its own face.

use lexican_runtime::{
    AbortCode, Address, Device as _, NodeId,
    od::{Access, DataType, OctetString, VisibleString},
};
use lexican_tests::sample::{device::Dictionary, quiet};
use lexican_tests::simulated::{Object, Simulated};
use proptest::prelude::*;

#[test]
fn every_entry_is_found_and_nothing_else() {
    let device = quiet();
    let table = device.table();
    let mut found = 0;
    for index in 0..=0xFFFF {
        for sub in 0..=0xFF {
            found += u32::from(table.find(Address::new(index, sub)).is_some());
        }
    }
    assert_eq!(found, 28);
    assert!(!table.has_object(0x0000), "the empty places are no object");
}

#[test]
fn the_node_id_is_in_the_values_of_its_formulas() {
    let od = Dictionary::new(NodeId::new(0x10).unwrap());
    assert_eq!(od.cob_id_emcy, 0x90);
    assert_eq!(od.sdo_server_parameter.cob_id_client_to_server, 0x610);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_set_of_addresses_can_be_placed_and_found(
        addresses in proptest::collection::btree_set((1..=u16::MAX, any::<u8>()), 0..400),
        others in proptest::collection::vec((any::<u16>(), any::<u8>()), 100),
    ) {
        let objects: Vec<Object> = addresses.iter().map(|&(index, sub)| byte(index, sub)).collect();
        let device = Simulated::new(&objects);
        for &(index, sub) in addresses.iter().chain(&others) {
            let found = device.table().find(Address::new(index, sub)).map(|entry| (entry.index, entry.sub));
            prop_assert_eq!(found, addresses.get(&(index, sub)).copied());
            prop_assert_eq!(device.table().has_object(index), addresses.iter().any(|address| address.0 == index));
        }
    }
}

fn byte(index: u16, sub: u8) -> Object {
    Object {
        address: Address::new(index, sub),
        data_type: DataType::UNSIGNED8,
        access: Access::READ,
        default: vec![0],
        limits: None,
        capacity: 0,
    }
}

#[test]
fn a_string_holds_what_fits_and_says_what_does_not() {
    let mut text = VisibleString::<4>::new(b"too long");
    assert_eq!(text.as_bytes(), b"too ");
    assert_eq!(text.set(b"12345"), Err(AbortCode::TOO_LONG));
    assert_eq!(text.as_bytes(), b"too ", "a refused value changes nothing");
    text.set(b"12").unwrap();
    assert_eq!((text.as_str(), text.capacity()), (Some("12"), 4));
    assert_eq!(text, VisibleString::new(b"12"), "what was there before does not count");
    assert_eq!(OctetString::<2>::new(&[0xFF]).as_str(), None);
    assert_eq!(OctetString::<0>::EMPTY.as_bytes(), b"");
}
