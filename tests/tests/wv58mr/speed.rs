//! Speed (5.7.2.23, 5.7.2.24, 5.7.2.33, 5.7.2.34, 5.7.2.44).

use crate::device::{Bus, Client, delivered};
use lexican_runtime::profile::encoder::Faults;
use lexican_tests::encoder::Hand;

const INVALID: u32 = 0x0609_0030;

/// Turns the shaft for so long.
fn run(bus: &mut Bus, shaft: &Hand, steps_per_ms: i64, millis: u32) {
    for _ in 0..millis {
        shaft.turn(steps_per_ms);
        bus.advance(1);
    }
}

fn speed(bus: &mut Bus) -> i16 {
    bus.get(0x6030, 1).to_le_bytes()[..2]
        .try_into()
        .map(i16::from_le_bytes)
        .expect("two bytes")
}

#[test]
fn the_speed_is_in_steps_per_ms_and_signed() {
    let (mut bus, shaft) = delivered();
    run(&mut bus, &shaft, 273, 200);
    assert_eq!(speed(&mut bus), 273);
    run(&mut bus, &shaft, -273, 200);
    assert_eq!(speed(&mut bus), -273);
    run(&mut bus, &shaft, 0, 200);
    assert_eq!(speed(&mut bus), 0);
}

#[test]
fn the_speed_is_that_of_the_raw_position_whatever_the_scaling_and_the_direction() {
    let (mut bus, shaft) = delivered();
    bus.set(0x6001, 0, &[1, 0, 0, 0]).set(0x6000, 0, &[5, 0]);
    run(&mut bus, &shaft, 100, 200);
    assert_eq!(speed(&mut bus), 100);
}

#[test]
fn a_change_is_averaged_over_the_integration_time_of_100_ms() {
    let (mut bus, shaft) = delivered();
    run(&mut bus, &shaft, 0, 200);
    run(&mut bus, &shaft, 100, 50);
    assert_eq!(speed(&mut bus), 50);
    run(&mut bus, &shaft, 100, 50);
    assert_eq!(speed(&mut bus), 100);
}

#[test]
fn the_speed_parameters_take_the_values_that_are_printed() {
    let (mut bus, _) = delivered();
    let defaults = [1, 2, 3, 4].map(|sub| bus.get(0x6031, sub));
    assert_eq!(defaults, [2, 100, 1, 1]);
    bus.set(0x6031, 1, &[2]).set(0x6031, 3, &[1, 0]).set(0x6031, 4, &[1, 0]);
    bus.refuse(0x6031, 1, &[1], INVALID)
        .refuse(0x6031, 2, &[0xC8, 0], 0x0601_0002)
        .refuse(0x6031, 3, &[2, 0], INVALID)
        .refuse(0x6031, 4, &[0, 0], INVALID);
}

#[test]
fn a_limit_speed_that_is_passed_is_a_warning_and_an_emergency_until_it_is_kept_again() {
    let (mut bus, shaft) = delivered();
    bus.set(0x2003, 0, &(-100_i16).to_le_bytes())
        .set(0x2004, 0, &200_i16.to_le_bytes());
    run(&mut bus, &shaft, 200, 200);
    assert_eq!(bus.silence().get(0x6505, 0), 0);
    run(&mut bus, &shaft, 201, 200);
    assert_eq!(bus.expect("081#14FF810000000000").silence().get(0x6505, 0), 1);
    run(&mut bus, &shaft, 0, 200);
    assert_eq!(bus.expect("081#0000000000000000").silence().get(0x6505, 0), 0);
    run(&mut bus, &shaft, -101, 200);
    assert_eq!(bus.expect("081#13FF810000000000").silence().get(0x6505, 0), 1);
    run(&mut bus, &shaft, 0, 200);
    bus.expect("081#0000000000000000").silence();
}

#[test]
fn limit_speeds_as_delivered_are_not_watched() {
    let (mut bus, shaft) = delivered();
    run(&mut bus, &shaft, 500, 200);
    assert_eq!(bus.silence().get(0x6505, 0), 0);
}

#[test]
fn a_shaft_that_is_too_fast_for_the_sensor_is_a_velocity_error() {
    let (mut bus, shaft) = delivered();
    shaft.break_down(Faults::SPEED);
    bus.advance(1).expect("081#12FF810000000000").silence();
    assert_eq!([bus.get(0x6505, 0), bus.get(0x6506, 0)], [1, 1]);
    shaft.break_down(Faults::NONE);
    bus.advance(1).expect("081#0000000000000000").silence();
    assert_eq!(bus.get(0x6505, 0), 0);
}
