//! The dictionary as it is delivered (5.7.1, 5.7.2), and the error codes of table 13.

use std::{fs, path::Path};

use lexican_eds::ir;
use lexican_runtime::{Address, profile::encoder};
use lexican_tests::encoder::Hand;
use lexican_wv58mr::{Encoder, Identity, Model, Variant};

use crate::device::{Bus, Client, One, booted, delivered, shaft};

/// Every value that the file of the variant says, against what the encoder says.
fn hold_against(file: &str, bus: &mut Bus) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../eds/devices/{file}"));
    let reading = lexican_eds::read(file, fs::read(path).expect("the device's file"));
    let node_id = ir::NodeId::new(1);
    for entry in reading.dictionary.entries().filter(|entry| entry.access.readable()) {
        let address = Address::new(entry.address.index, entry.address.sub);
        let Some(default) = &entry.default else { continue };
        if address.index == 0x1003 && address.sub != 0 {
            // There are none yet.
            continue;
        }
        let value = bus.node().read(address).expect("it can be read");
        let mut bytes = value.to_bytes().to_vec();
        if bytes.is_empty() {
            bytes = value.bits().to_le_bytes()[..entry.data_type.bytes().unwrap_or(0)].to_vec();
        }
        assert_eq!(bytes, default.to_bytes(entry.data_type, node_id), "{address}");
    }
}

#[test]
fn every_object_reads_as_the_file_of_its_variant_says() {
    hold_against("wv58mr.eds", &mut booted(&shaft(Variant::MultiTurn12)));
    hold_against("wv58mr-st.eds", &mut booted(&shaft(Variant::SingleTurn)));
}

#[test]
fn the_hollow_shaft_has_a_name_of_its_own() {
    let identity = Identity {
        model: Model::Wh58mr,
        ..Identity::default()
    };
    let encoder = Encoder::with_storage(shaft(Variant::MultiTurn8), identity, crate::device::eeprom());
    let mut bus: Bus = lexican_tests::bus::Bus::with(One(encoder.expect("a sensor of this encoder")));
    bus.advance(0).expect("701#00");
    bus.send("601#4008100000000000").expect("581#4108100006000000");
    bus.send("601#6000000000000000").expect("581#03574835384D5200");
}

#[test]
fn a_sensor_of_another_encoder_is_refused() {
    let other = Hand::new(encoder::Shaft::new(8192, 4096).expect("a shaft"));
    assert!(Encoder::new(other, Identity::default()).is_err());
}

#[test]
fn the_error_codes_are_those_of_table_13() {
    let (mut bus, _) = delivered();
    // 0503 0000h: the toggle bit.
    bus.send("601#4008100000000000").expect("581#41..");
    bus.send("601#7000000000000000").expect("581#8008100000000305");
    bus.refuse(0x6004, 0, &[0; 4], 0x0601_0002)
        .refuse(0x3000, 0, &[0], 0x0602_0000)
        .refuse(0x6000, 1, &[0], 0x0609_0011)
        .refuse(0x1017, 0, &[5, 0], 0x0609_0030)
        .refuse(0x1010, 1, b"evas", 0x0800_0020);
    bus.send("601#4002200000000000").expect("581#8002200001000106");
    bus.send("601#4003100100000000").expect("581#8003100124000008");
    bus.send("000#0101").refuse(0x1014, 0, &[0x85, 0, 0, 0x80], 0x0800_0022);
}
