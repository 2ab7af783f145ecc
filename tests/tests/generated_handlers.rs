//! A device with more handlers than one function of the generated code chooses from.

use lexican_runtime::{AbortCode, Address, od};
use lexican_tests::generated::wv58mr_handled::{Device, Dictionary, Handlers};

/// Notes which method was called with what.
#[derive(Default)]
struct App(Vec<(&'static str, i64)>);

macro_rules! note {
    ($($method:ident: $value:ty,)*) => {
        impl Handlers for App {
            $(fn $method(&mut self, _: &mut Dictionary, value: $value) -> Result<(), AbortCode> {
                self.0.push((stringify!($method), i64::from(value)));
                Ok(())
            })*
        }
    };
}

note! {
    write_cob_id_sync_message: u32,
    write_guard_time: u16,
    write_life_time_factor: u8,
    write_cob_id_emergency_message: u32,
    write_producer_heartbeat_time: u16,
    write_tpdo_1_communication_cob_id: u32,
    write_tpdo_1_communication_transmission_type: u8,
    write_tpdo_1_communication_event_timer: u16,
    write_tpdo_2_communication_cob_id: u32,
    write_tpdo_2_communication_transmission_type: u8,
    write_application_offset: i32,
    write_limit_speed_low: i16,
    write_limit_speed_high: i16,
    write_operating_parameters: u16,
    write_measuring_units_per_revolution: u32,
    write_total_measuring_range: u32,
    write_preset_value: u32,
    write_speed_parameters_speed_source_selector: u8,
    write_speed_parameters_speed_multiplier: u16,
    write_speed_parameters_speed_divisor: u16,
    write_cycle_timer: u16,
}

#[test]
fn each_object_has_its_own_handler() {
    let mut device = Device::new(App::default());
    let writes: [(u16, u8, &[u8], &str); 6] = [
        (0x1005, 0, &[1, 0, 0, 0], "write_cob_id_sync_message"),
        (0x1801, 2, &[2], "write_tpdo_2_communication_transmission_type"),
        (0x6001, 0, &[3, 0, 0, 0], "write_measuring_units_per_revolution"),
        (0x6002, 0, &[4, 0, 0, 0], "write_total_measuring_range"),
        (0x6031, 4, &[5, 0], "write_speed_parameters_speed_divisor"),
        (0x6200, 0, &[6, 0], "write_cycle_timer"),
    ];
    for (index, sub, data, _) in writes {
        od::write(&mut device, &mut (), Address::new(index, sub), data).unwrap();
    }
    let expected: Vec<(&str, i64)> = writes.iter().map(|write| write.3).zip(1..).collect();
    assert_eq!(device.handlers.0, expected);
}
