//! The dictionary of the sample device, by its own face.

use lexican_runtime::{Address, Device as _, NodeId};
use lexican_tests::sample::device::{Device, Dictionary, Handlers};

struct NoHandlers;

impl Handlers for NoHandlers {
    fn write_preset_value(&mut self, _: &mut Dictionary, _: u32) -> Result<(), lexican_runtime::AbortCode> {
        Ok(())
    }

    fn read_position_value(&mut self, _: &mut Dictionary) -> Result<(), lexican_runtime::AbortCode> {
        Ok(())
    }
}

#[test]
fn every_entry_is_found_and_nothing_else() {
    let device = Device::new(NoHandlers);
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
