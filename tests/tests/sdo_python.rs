//! python-canopen as SDO client: long values in segments and in blocks, with and without a CRC, on two servers.

use lexican_runtime::od::DataType;
use lexican_tests::{
    bus::Bus,
    python,
    simulated::{Object, Simulated},
};

fn long(index: u16, data_type: DataType) -> Object {
    Object {
        data_type,
        default: Vec::new(),
        capacity: 5000,
        ..Object::number(index, 0, 1, 0)
    }
}

#[test]
fn python_canopen_reads_what_it_has_written_in_every_manner_on_both_servers() {
    let Some(python) = python::with_canopen() else { return };
    let mut bus = Bus::booted(
        Simulated::new(&[
            long(0x2001, DataType::VISIBLE_STRING),
            long(0x2002, DataType::DOMAIN),
            Object::number(0x1201, 1, 4, 0x680),
            Object::number(0x1201, 2, 4, 0x690),
        ]),
        1,
    );
    let frames = python::talk(&mut bus, &python, "sdo_client.py", []);
    // The longest value alone has 715 segments, and goes there and back many times.
    assert!(frames > 10_000, "{frames} frames");
    bus.advance(2000).silence();
}
