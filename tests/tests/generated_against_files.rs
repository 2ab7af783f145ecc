//! Every device's generated code, value by value, against the file that it was generated from, as the IR has it.

use std::{fs, path::Path};

use lexican_eds::ir::{self, AccessType, DataType, Dictionary, Entry, Value};
use lexican_runtime::{
    AbortCode, Address, Device,
    od::{self, Access},
};
use lexican_tests::generated;

fn dictionary(path: &str) -> Dictionary {
    let bytes = fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)).expect("a file of the project");
    lexican_eds::read(path, bytes).dictionary
}

/// Holds `device` against the file that it was generated from.
fn check(path: &str, device: &mut impl Device) {
    let dictionary = dictionary(path);
    let entries: Vec<&Entry> = dictionary.entries().collect();
    let rows = device.table().entries.iter();
    assert_eq!(rows.filter(|row| row.data_type.0 != 0).count(), entries.len(), "{path}");
    for entry in entries {
        check_row(device, entry);
        check_value(device, entry);
        if entry.access.writable() {
            check_limits(device, entry);
        }
    }
}

fn row(device: &impl Device, entry: &Entry) -> od::Entry {
    let ir::Address { index, sub } = entry.address;
    let row = device.table().find(Address::new(index, sub));
    row.unwrap_or_else(|| panic!("{} is missing", entry.address))
}

fn check_row(device: &impl Device, entry: &Entry) {
    let row = row(device, entry);
    assert_eq!(u16::from(row.data_type.0), entry.data_type.index(), "{}", entry.address);
    assert_eq!(
        row.access.has(Access::READ),
        entry.access != AccessType::Wo,
        "{}",
        entry.address
    );
    assert_eq!(
        row.access.has(Access::WRITE),
        entry.access.writable(),
        "{}",
        entry.address
    );
    let mappable = row.access.has(Access::TPDO) || row.access.has(Access::RPDO);
    assert_eq!(mappable, entry.pdo_mapping, "{}", entry.address);
}

/// The value after power-on is the file's; where the file gives none it is zero or empty.
fn check_value(device: &impl Device, entry: &Entry) {
    let value = on_the_bus(od::load(device, row(device, entry)).expect("an entry of this table"));
    let expected = match &entry.default {
        Some(default) => default.to_bytes(entry.data_type, None),
        None => vec![0; entry.data_type.bytes().unwrap_or(0)],
    };
    assert_eq!(value, expected, "{}", entry.address);
}

fn on_the_bus(value: od::Value<'_>) -> Vec<u8> {
    match value {
        od::Value::Number { bits, data_type } => bits.to_le_bytes()[..data_type.length()].to_vec(),
        od::Value::Bytes(bytes) => bytes.to_vec(),
    }
}

/// A client may write the limits, and nothing beyond them.
fn check_limits(device: &mut impl Device, entry: &Entry) {
    let address = Address::new(entry.address.index, entry.address.sub);
    let mut write = |value: i128| {
        let bytes = value.to_le_bytes();
        od::write(
            device,
            &mut (),
            address,
            &bytes[..entry.data_type.bytes().expect("a number")],
        )
    };
    let (least, greatest) = range(entry.data_type);
    if let Some(low) = entry.low.as_ref().and_then(integer) {
        assert_eq!(write(low), Ok(()), "{}: its low limit", entry.address);
        if low > least {
            assert_eq!(write(low - 1), Err(AbortCode::VALUE_TOO_LOW), "{}", entry.address);
        }
    }
    if let Some(high) = entry.high.as_ref().and_then(integer) {
        assert_eq!(write(high), Ok(()), "{}: its high limit", entry.address);
        if high < greatest {
            assert_eq!(write(high + 1), Err(AbortCode::VALUE_TOO_HIGH), "{}", entry.address);
        }
    }
}

fn range(data_type: DataType) -> (i128, i128) {
    let bits = data_type.bits().expect("a number");
    if data_type.is_signed() {
        (-(1 << (bits - 1)), (1 << (bits - 1)) - 1)
    } else {
        (0, (1 << bits) - 1)
    }
}

fn integer(value: &Value) -> Option<i128> {
    match value {
        Value::Integer(value) => Some(i128::from(*value)),
        Value::Unsigned(value) => Some(i128::from(*value)),
        _ => None,
    }
}

#[test]
fn wdga() {
    check("eds/devices/wdga.eds", &mut generated::wdga::Device::new(()));
}

#[test]
fn wdga_singleturn() {
    check("eds/devices/wdga-st.eds", &mut generated::wdga_st::Device::new(()));
}

#[test]
fn wdga_configured() {
    check("eds/devices/wdga.dcf", &mut generated::wdga_configured::Device::new(()));
}

#[test]
fn wv58mr() {
    check("eds/devices/wv58mr.eds", &mut generated::wv58mr::Device::new(()));
}

#[test]
fn wv58mr_singleturn() {
    check("eds/devices/wv58mr-st.eds", &mut generated::wv58mr_st::Device::new(()));
}

#[test]
fn wv58mr_configured() {
    check(
        "eds/devices/wv58mr.dcf",
        &mut generated::wv58mr_configured::Device::new(()),
    );
}

#[test]
fn cia406() {
    check("eds/devices/cia406.eds", &mut generated::cia406::Device::new(()));
}

#[test]
fn cia406_of_many_channels() {
    check(
        "eds/devices/cia406-multi.eds",
        &mut generated::cia406_multi::Device::new(()),
    );
}
