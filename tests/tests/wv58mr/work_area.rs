//! Work areas (5.7.2.36 to 5.7.2.38, 5.7.2.42, 5.7.2.43).

use crate::device::{Bus, Client, booted, delivered, shaft};
use lexican_wv58mr::Variant;

const TOO_HIGH: u32 = 0x0609_0031;
const TOO_LOW: u32 = 0x0609_0032;

fn limit(bus: &mut Bus, area: u8, low: i32, high: i32) {
    bus.set(0x6401, area, &low.to_le_bytes())
        .set(0x6402, area, &high.to_le_bytes());
}

fn states(bus: &mut Bus) -> [u32; 3] {
    bus.advance(1);
    [bus.get(0x6400, 1), bus.get(0x6400, 2), bus.get(0x6503, 0)]
}

#[test]
fn each_area_has_its_state_its_alarm_and_its_emergency() {
    let (mut bus, shaft) = delivered();
    shaft.put(1500);
    bus.advance(1);
    // The upper limit first: then neither is ever passed on the way.
    for (area, low, high) in [(1, 1000_i32, 2000_i32), (2, 1400, 3000)] {
        bus.set(0x6402, area, &high.to_le_bytes())
            .set(0x6401, area, &low.to_le_bytes());
    }
    assert_eq!(states(&mut bus), [0, 0, 0]);
    shaft.put(2001);
    assert_eq!(states(&mut bus), [0b011, 0, 0x1000]);
    bus.expect("081#15FF810000000000").silence();
    shaft.put(999);
    assert_eq!(states(&mut bus), [0b101, 0b101, 0x3000]);
    bus.expect("081#16FF810000000000").silence();
    shaft.put(3001);
    assert_eq!(states(&mut bus), [0b011, 0b011, 0x3000]);
    bus.silence();
    // One cause is gone: 0000h, and the register still shows the other.
    shaft.put(3000);
    assert_eq!(states(&mut bus), [0b011, 0, 0x1000]);
    bus.expect("081#0000810000000000").silence();
    shaft.put(2000);
    assert_eq!(states(&mut bus), [0, 0, 0]);
    bus.expect("081#0000000000000000").silence();
    assert_eq!(bus.get(0x6504, 0), 0x3001);
}

#[test]
fn work_areas_as_delivered_are_not_watched() {
    let (mut bus, shaft) = delivered();
    shaft.put(5);
    assert_eq!(states(&mut bus), [0, 0, 0]);
    bus.silence();
}

#[test]
fn limits_are_positions_of_the_variant() {
    for variant in Variant::ALL {
        let mut bus = booted(&shaft(variant));
        let range = variant.range(16_384).cast_signed();
        for index in [0x6401, 0x6402] {
            for area in [1, 2] {
                bus.refuse(index, area, &range.to_le_bytes(), TOO_HIGH).refuse(
                    index,
                    area,
                    &(-1_i32).to_le_bytes(),
                    TOO_LOW,
                );
            }
        }
        bus.refuse(0x6402, 3, &range.to_le_bytes(), 0x0609_0011);
        limit(&mut bus, 1, 0, range - 1);
        bus.set(0x6001, 0, &[1, 0, 0, 0])
            .refuse(0x6402, 1, &i32::from(variant.revolutions()).to_le_bytes(), TOO_HIGH);
    }
}
