//! A simulated node with every object of EMCY, SYNC and PDO, for the tests of those services.

use lexican_runtime::{
    Address, Device,
    od::{Access, DataType},
};

use crate::{
    bus::Bus,
    line,
    simulated::{Object, Simulated},
};

/// Node 1, booted, in PRE-OPERATIONAL:
///
/// | PDO | COB-ID | type | mapped |
/// |---|---|---|---|
/// | TPDO 1 | 181h | 1 | 6004h u32, 6005h u16, 2001h u8: `44 33 22 11 66 55 77` |
/// | TPDO 2 | 281h | 254 | 2001h u8 |
/// | TPDO 4 | 4000 0481h, not valid | 254 | nothing; room for 64 |
/// | RPDO 1 | 201h | 255 | 6200h u16, 2010h u8 (1 to 10) |
/// | RPDO 2 | 301h | 1 | 6200h u16 |
///
/// 2002h is a u64 and 2003h and 2004h are BOOLEANs, all mappable both ways; 2005h is not mappable.
///
/// # Panics
/// When it does not boot.
#[must_use]
pub fn node() -> Bus<Simulated> {
    Bus::booted(Simulated::new(&objects()).with_dummies(0b0110_0000), 1)
}

/// The same, OPERATIONAL.
///
/// # Panics
/// As [`node`].
#[must_use]
pub fn operational() -> Bus<Simulated> {
    let mut bus = node();
    bus.send("000#0101").silence();
    bus
}

/// Its objects.
#[must_use]
pub fn objects() -> Vec<Object> {
    let mut objects = vec![
        Object::number(0x1001, 0, 1, 0),
        Object::number(0x1005, 0, 4, 0x80),
        Object::number(0x1006, 0, 4, 0),
        Object::number(0x1007, 0, 4, 0),
        Object::number(0x1014, 0, 4, 0x80).with(Access::NODE_ID),
        Object::number(0x1019, 0, 1, 0),
    ];
    objects.extend(application());
    objects.extend(pdo(0x1800, 0x180, 1, &[0x6004_0020, 0x6005_0010, 0x2001_0008], 8));
    objects.extend(pdo(0x1801, 0x280, 254, &[0x2001_0008], 8));
    objects.extend(pdo(0x1803, 0xC000_0480, 254, &[], 64));
    objects.extend(pdo(0x1400, 0x200, 255, &[0x6200_0010, 0x2010_0008], 8));
    objects.extend(pdo(0x1401, 0x300, 1, &[0x6200_0010], 8));
    objects
}

fn application() -> Vec<Object> {
    let both = Access::TPDO.with(Access::RPDO);
    let boolean = |index| Object {
        data_type: DataType::BOOLEAN,
        ..Object::number(index, 0, 1, 0).with(both)
    };
    let limited = Object {
        limits: Some((vec![1], vec![10])),
        ..Object::number(0x2010, 0, 1, 5).with(Access::RPDO)
    };
    vec![
        Object::number(0x2001, 0, 1, 0x77).with(Access::TPDO),
        Object::number(0x2002, 0, 8, 0x0102_0304_0506_0708).with(both),
        boolean(0x2003),
        boolean(0x2004),
        Object::number(0x2005, 0, 1, 0),
        limited,
        Object::number(0x6004, 0, 4, 0x1122_3344).with(Access::TPDO),
        Object::number(0x6005, 0, 2, 0x5566).with(Access::TPDO),
        Object::number(0x6200, 0, 2, 0).with(Access::RPDO),
    ]
}

/// The parameters of a PDO; its COB-ID has the node-ID added.
fn pdo(index: u16, cob_id: u64, transmission_type: u64, mapped: &[u64], room: u8) -> Vec<Object> {
    let mapping = index + 0x200;
    let mut objects = vec![
        Object::number(index, 0, 1, 6),
        Object::number(index, 1, 4, cob_id).with(Access::NODE_ID),
        Object::number(index, 2, 1, transmission_type),
        Object::number(index, 3, 2, 0),
        Object::number(index, 5, 2, 0),
        Object::number(index, 6, 1, 0),
        Object::number(mapping, 0, 1, mapped.len() as u64),
    ];
    let entries = mapped.iter().copied().chain(std::iter::repeat(0));
    objects.extend(
        (1..=room)
            .zip(entries)
            .map(|(sub, entry)| Object::number(mapping, sub, 4, entry)),
    );
    objects
}

/// Writes `value` to an object of node 1, as a client does; the answer is to be awaited.
///
/// # Panics
/// When it has not one to four bytes.
pub fn write<'a, D: Device>(bus: &'a mut Bus<D>, index: u16, sub: u8, value: &[u8]) -> &'a mut Bus<D> {
    let command = 0x2F - 4 * (u8::try_from(value.len()).expect("1 to 4 bytes") - 1);
    let [low, high] = index.to_le_bytes();
    let mut data = [command, low, high, sub, 0, 0, 0, 0];
    data[4..4 + value.len()].copy_from_slice(value);
    bus.send(&format!("601#{}", line::hex(&data)))
}

/// Writes, and the node takes it.
///
/// # Panics
/// When it does not.
#[track_caller]
pub fn set<'a, D: Device>(bus: &'a mut Bus<D>, index: u16, sub: u8, value: &[u8]) -> &'a mut Bus<D> {
    write(bus, index, sub, value).expect("581#60..")
}

/// Writes, and the node refuses with this abort code.
///
/// # Panics
/// When it answers something else.
#[track_caller]
pub fn refuse<'a, D: Device>(bus: &'a mut Bus<D>, (index, sub): (u16, u8), value: &[u8], code: u32) -> &'a mut Bus<D> {
    let [low, high] = index.to_le_bytes();
    let abort = [&[0x80, low, high, sub][..], &code.to_le_bytes()].concat();
    write(bus, index, sub, value).expect(&format!("581#{}", line::hex(&abort)))
}

/// The value of an object as a number.
///
/// # Panics
/// When it cannot be read.
#[must_use]
pub fn number(bus: &mut Bus<Simulated>, index: u16) -> u64 {
    let value = bus.node().read(Address::new(index, 0));
    value.expect("such an object").bits()
}
