//! Position, calibration and what scales it (4.1, 4.2, 5.7.2.21, 5.7.2.22, 5.7.2.27 to 5.7.2.32, 5.7.2.48, 5.7.2.49).

use lexican_wv58mr::Variant;

use crate::device::{Client, booted, delivered, shaft};

const INVALID: u32 = 0x0609_0030;
const TOO_HIGH: u32 = 0x0609_0031;
const TOO_LOW: u32 = 0x0609_0032;

#[test]
fn each_variant_counts_as_far_as_chapter_4_1_says() {
    let printed = [
        (Variant::SingleTurn, 16_383, 65_534, 0x0001_0196),
        (Variant::MultiTurn4, 262_143, 1_048_559, 0x0002_0196),
        (Variant::MultiTurn8, 4_194_303, 16_776_959, 0x0002_0196),
        (Variant::MultiTurn12, 67_108_863, 268_431_359, 0x0002_0196),
    ];
    for (variant, last, last_of_65535, device_type) in printed {
        let shaft = shaft(variant);
        let mut bus = booted(&shaft);
        assert_eq!(bus.get(0x1000, 0), device_type);
        assert_eq!(bus.get(0x6502, 0), u32::from(variant.revolutions()));
        shaft.put(-1);
        bus.advance(1);
        assert_eq!([bus.get(0x6004, 0), bus.get(0x600C, 0)], [last, last]);
        assert_eq!([bus.get(0x6002, 0), bus.get(0x650A, 3)], [last + 1, last]);
        bus.set(0x6001, 0, &65_535_u32.to_le_bytes()).advance(1);
        assert_eq!(bus.get(0x6004, 0), last_of_65535 - 3, "four units a step");
        assert_eq!(
            [bus.get(0x6002, 0), bus.get(0x650A, 3)],
            [last_of_65535 + 1, last_of_65535]
        );
        assert_eq!(bus.get(0x600C, 0), last, "the raw value is not scaled");
        bus.refuse(0x6003, 0, &(last_of_65535 + 1).to_le_bytes(), TOO_HIGH).set(
            0x6003,
            0,
            &last_of_65535.to_le_bytes(),
        );
    }
}

#[test]
fn the_counting_direction_is_bit_0_of_6000h_and_scaling_cannot_be_disabled() {
    let (mut bus, shaft) = delivered();
    shaft.put(100);
    bus.advance(1);
    assert_eq!(bus.get(0x6004, 0), 100);
    bus.set(0x6000, 0, &[5, 0]).advance(1);
    assert_eq!(bus.get(0x6004, 0), 67_108_864 - 100);
    assert_eq!(bus.get(0x6500, 0), 5);
    for refused in [[0, 0], [1, 0], [6, 0], [0x0C, 0], [4, 1]] {
        bus.refuse(0x6000, 0, &refused, INVALID);
    }
    assert_eq!(bus.set(0x6000, 0, &[4, 0]).get(0x6500, 0), 4);
}

#[test]
fn calibration_gives_the_position_its_value() {
    let (mut bus, shaft) = delivered();
    shaft.put(1000);
    // The value alone changes nothing.
    bus.set(0x6003, 0, &4500_u32.to_le_bytes()).advance(1);
    assert_eq!(bus.get(0x6004, 0), 1000);
    for refused in [0, 2, 255] {
        bus.refuse(0x2002, 0, &[refused], INVALID);
    }
    bus.set(0x2002, 0, &[1]).advance(1);
    assert_eq!(bus.get(0x6004, 0), 4500);
    assert_eq!(bus.get(0x6509, 0), 3500);
    assert_eq!(bus.get(0x600C, 0), 1000);
    shaft.put(900);
    bus.advance(1);
    assert_eq!(bus.get(0x6004, 0), 4400);
    bus.send("601#4002200000000000").expect("581#8002200001000106");
}

#[test]
fn the_application_offset_is_added_to_the_calibrated_position() {
    let (mut bus, shaft) = delivered();
    shaft.put(1000);
    bus.set(0x2001, 0, &(-20_i32).to_le_bytes()).advance(1);
    assert_eq!(bus.get(0x6004, 0), 980);
    bus.set(0x6003, 0, &[50, 0, 0, 0]).set(0x2002, 0, &[1]).advance(1);
    assert_eq!(bus.get(0x6004, 0), 30, "0 + calibration value + application offset");
    assert_eq!(bus.get(0x6509, 0).cast_signed(), -970);
    bus.set(0x2001, 0, &[0; 4]).advance(1);
    assert_eq!(bus.get(0x6004, 0), 50);
}

#[test]
fn a_position_below_0_is_one_at_the_end_of_the_range() {
    let (mut bus, _) = delivered();
    bus.set(0x2001, 0, &(-1_i32).to_le_bytes()).advance(1);
    assert_eq!(bus.get(0x6004, 0), 67_108_863);
}

#[test]
fn the_application_offset_is_within_the_physical_range_of_the_variant() {
    for (variant, steps) in Variant::ALL.into_iter().zip([16_384, 262_144, 4_194_304, 67_108_864]) {
        let mut bus = booted(&shaft(variant));
        bus.set(0x2001, 0, &i32::to_le_bytes(-steps))
            .set(0x2001, 0, &i32::to_le_bytes(steps - 1))
            .refuse(0x2001, 0, &i32::to_le_bytes(-steps - 1), TOO_LOW)
            .refuse(0x2001, 0, &i32::to_le_bytes(steps), TOO_HIGH);
    }
}

#[test]
fn measuring_units_are_1_to_65535_and_the_total_range_follows_them() {
    let (mut bus, shaft) = delivered();
    bus.refuse(0x6001, 0, &[0; 4], TOO_LOW)
        .refuse(0x6001, 0, &65_536_u32.to_le_bytes(), TOO_HIGH)
        .set(0x6001, 0, &360_u32.to_le_bytes());
    shaft.put(3 * 16_384 + 8192);
    bus.advance(1);
    assert_eq!(bus.get(0x6004, 0), 3 * 360 + 180);
    assert_eq!(bus.get(0x6002, 0), 360 * 4096);
    bus.refuse(0x6002, 0, &1000_u32.to_le_bytes(), INVALID)
        .set(0x6002, 0, &(360_u32 * 4096).to_le_bytes());
    assert_eq!(
        [bus.get(0x650A, 1), bus.get(0x650A, 2), bus.get(0x650A, 3)],
        [0, 0, 360 * 4096 - 1]
    );
    // A calibration value of before that is no position any more.
    bus.set(0x6003, 0, &(360_u32 * 4096 - 1).to_le_bytes())
        .set(0x6001, 0, &[1, 0, 0, 0])
        .refuse(0x2002, 0, &[1], TOO_HIGH);
}

#[test]
fn the_position_does_not_jump_where_the_revolutions_end() {
    let (mut bus, shaft) = delivered();
    bus.set(0x6001, 0, &1000_u32.to_le_bytes());
    shaft.put(-1);
    bus.advance(1);
    assert_eq!(bus.get(0x6004, 0), 4_095_999);
    shaft.put(0);
    bus.advance(1);
    assert_eq!(bus.get(0x6004, 0), 0);
}
