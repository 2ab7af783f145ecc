//! 1010h and 1011h (4.3, 5.7.2.11, 5.7.2.12), and the rows "EEPROM" of 5.7.2.

use crate::device::{Bus, Client, eeprom, shaft, switched_on};
use lexican_tests::memory::Memory;
use lexican_wv58mr::Variant;

/// Index, sub-index, value.
type Change = (u16, u8, &'static [u8]);

/// A value other than the default for what is stored of each group: communication, application, manufacturer. The timer of
/// TPDO 1, which is in two groups, has a test of its own.
const CHANGES: [(u8, &[Change]); 3] = [
    (
        2,
        &[
            (0x1005, 0, &[0x81, 0, 0, 0]),
            (0x100C, 0, &[100, 0]),
            (0x100D, 0, &[3]),
            (0x1014, 0, &[0x81, 0, 0, 0x80]),
            (0x1017, 0, &[0, 1]),
            (0x1800, 1, &[0x81, 1, 0, 0x80]),
            (0x1800, 2, &[255]),
            (0x1801, 1, &[0x81, 2, 0, 0x80]),
            (0x1801, 2, &[7]),
        ],
    ),
    (
        3,
        &[
            (0x6001, 0, &[0, 1, 0, 0]),
            (0x6000, 0, &[5, 0]),
            (0x6003, 0, &[9, 0, 0, 0]),
            (0x6401, 1, &[1, 0, 0, 0]),
            (0x6401, 2, &[2, 0, 0, 0]),
            (0x6402, 1, &[30, 0, 0, 0]),
            (0x6402, 2, &[40, 0, 0, 0]),
        ],
    ),
    (
        4,
        &[
            (0x2001, 0, &[3, 0, 0, 0]),
            (0x2003, 0, &[0xFE, 0xFF]),
            (0x2004, 0, &[70, 0]),
            (0x5F0A, 2, &[4]),
        ],
    ),
];

fn number(bytes: &[u8]) -> u32 {
    bytes
        .iter()
        .rev()
        .fold(0, |number, byte| number << 8 | u32::from(*byte))
}

/// What the group has now.
fn values(bus: &mut Bus, group: usize) -> Vec<u32> {
    let changes = CHANGES[group].1.iter();
    changes
        .map(|(index, sub, bytes)| {
            // A signed one has its sign in all 32 bits.
            bus.get(*index, *sub) & u32::MAX >> (32 - 8 * bytes.len())
        })
        .collect()
}

fn changed(group: usize) -> Vec<u32> {
    CHANGES[group].1.iter().map(|change| number(change.2)).collect()
}

fn boot(cells: &Memory) -> Bus {
    let mut bus = switched_on(&shaft(Variant::MultiTurn12), cells);
    while bus.advance(0).take().is_some() {}
    bus
}

/// An encoder on which everything was changed.
fn changed_encoder(cells: &Memory) -> Bus {
    let mut bus = boot(cells);
    for (index, sub, bytes) in CHANGES.iter().flat_map(|group| group.1) {
        bus.node()
            .write(lexican_runtime::Address::new(*index, *sub), bytes)
            .expect("it is allowed");
    }
    while bus.advance(0).take().is_some() {}
    bus
}

/// All values, with those of one group or all but those as they were changed, the others as delivered.
fn mixed(is_changed: impl Fn(usize) -> bool) -> Vec<Vec<u32>> {
    let mut delivered = boot(&eeprom());
    let groups = 0..CHANGES.len();
    groups
        .map(|group| {
            if is_changed(group) {
                changed(group)
            } else {
                values(&mut delivered, group)
            }
        })
        .collect()
}

fn all(bus: &mut Bus) -> Vec<Vec<u32>> {
    (0..CHANGES.len()).map(|group| values(bus, group)).collect()
}

#[test]
fn what_is_saved_is_there_after_power_off_group_by_group() {
    for (saved, (sub, _)) in CHANGES.iter().enumerate() {
        let cells = eeprom();
        changed_encoder(&cells).set(0x1010, *sub, b"save");
        assert_eq!(
            all(&mut boot(&cells)),
            mixed(|group| group == saved),
            "after saving {sub}"
        );
    }
}

#[test]
fn what_is_restored_is_as_delivered_after_a_reset_group_by_group() {
    for (restored, (sub, _)) in CHANGES.iter().enumerate() {
        let cells = eeprom();
        let mut bus = changed_encoder(&cells);
        bus.set(0x1010, 1, b"save").set(0x1011, *sub, b"load");
        assert_eq!(values(&mut bus, 0), changed(0), "not before the reset");
        assert_eq!(
            all(&mut boot(&cells)),
            mixed(|group| group != restored),
            "after restoring {sub}"
        );
    }
}

#[test]
fn everything_is_restored_by_sub_index_1() {
    let cells = eeprom();
    let mut bus = changed_encoder(&cells);
    bus.set(0x5F0A, 1, &[5]).set(0x1010, 1, b"save").set(0x1011, 1, b"load");
    let mut bus = switched_on(&shaft(Variant::MultiTurn12), &cells);
    bus.advance(0).expect("701#00");
    assert_eq!(all(&mut bus), mixed(|_| false));
}

#[test]
fn a_calibration_outlives_power_off_once_it_is_saved_and_a_reset_forgets_one_that_is_not() {
    let (shaft, cells) = (shaft(Variant::MultiTurn12), eeprom());
    shaft.put(1000);
    let mut bus = switched_on(&shaft, &cells);
    bus.advance(0).expect("701#00");
    bus.set(0x2001, 0, &[7, 0, 0, 0]).set(0x2002, 0, &[1]).advance(1);
    assert_eq!(bus.get(0x6004, 0), 7);
    bus.send("000#8101").expect("701#00").advance(1);
    assert_eq!([bus.get(0x6004, 0), bus.get(0x6509, 0)], [1000, 0]);
    bus.set(0x2001, 0, &[7, 0, 0, 0])
        .set(0x2002, 0, &[1])
        .set(0x1010, 1, b"save");
    let mut bus = switched_on(&shaft, &cells);
    bus.advance(0).expect("701#00");
    assert_eq!(
        [bus.get(0x6004, 0), bus.get(0x6509, 0).cast_signed().unsigned_abs()],
        [7, 993]
    );
    bus.set(0x2001, 0, &[0; 4]).advance(1);
    assert_eq!(bus.get(0x6004, 0), 0);
}

#[test]
fn the_timer_is_the_same_in_both_places_whichever_was_saved() {
    for group in [2, 3] {
        let cells = eeprom();
        let mut bus = boot(&cells);
        bus.set(0x6200, 0, &[20, 0]).set(0x1010, group, b"save");
        let mut bus = boot(&cells);
        assert_eq!([bus.get(0x6200, 0), bus.get(0x1800, 5)], [20, 20]);
        bus.send("000#0101").advance(20).expect("181#..");
    }
}

#[test]
fn capabilities_read_as_printed_and_a_wrong_signature_is_refused() {
    let mut bus = boot(&eeprom());
    for index in [0x1010, 0x1011] {
        assert_eq!(bus.get(index, 0), 4);
        for sub in 1..=4 {
            assert_eq!(bus.get(index, sub), 1);
            bus.refuse(index, sub, b"nope", 0x0800_0020);
        }
        bus.refuse(index, 5, b"save", 0x0609_0011);
    }
}
