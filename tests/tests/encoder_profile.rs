//! The encoder profile (CiA 406, 8.1 to 8.3) against arithmetic with numbers that cannot overflow.

use lexican_runtime::{
    AbortCode,
    profile::encoder::{Area, Cam, Cams, Filter, Parameters, Position, Reading, Shaft, area, speed, way},
};
use proptest::prelude::*;

/// An encoder as it is explained: a shaft that has turned so many steps since ever, and a position that is these steps, scaled and
/// rounded down, on the circle of the range.
struct Model {
    steps: i128,
    resolution: i128,
    units: i128,
    range: i128,
    offset: i128,
}

impl Model {
    fn position(&self, is_counterclockwise: bool) -> i128 {
        let steps = if is_counterclockwise { -self.steps } else { self.steps };
        ((steps * self.units).div_euclid(self.resolution) + self.offset).rem_euclid(self.range)
    }

    /// What a sensor with so many revolutions says.
    fn reading(&self, revolutions: i128) -> Reading {
        let turn = self.steps.div_euclid(self.resolution).rem_euclid(revolutions);
        let angle = self.steps.rem_euclid(self.resolution);
        Reading {
            turn: u64::try_from(turn).expect("below the revolutions"),
            angle: u32::try_from(angle).expect("below the resolution"),
        }
    }
}

/// Numbers at the boundaries, and others.
fn number(most: u64) -> impl Strategy<Value = u64> {
    prop_oneof![
        1..=most.min(10),
        (0u32..64).prop_map(move |bits| (1u64 << bits).min(most)),
        (0u32..64).prop_map(move |bits| ((1u64 << bits) - 1).clamp(1, most)),
        1..=most,
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    /// The shorter way leads there, and there is none shorter.
    #[test]
    fn the_shorter_way_leads_there(range in number(u64::MAX), from in any::<u64>(), to in any::<u64>()) {
        let (from, to) = (from % range, to % range);
        let way = i128::from(way(from, to, range));
        let [from, to, range] = [from, to, range].map(i128::from);
        // The longest ways do not fit into 64 bits, and are one short.
        if way < i128::from(i64::MAX) {
            prop_assert_eq!((from + way).rem_euclid(range), to);
        }
        prop_assert!(2 * way.abs() <= range, "{} of {}", way, range);
        prop_assert!(2 * way > -range, "half of the circle is forwards");
    }

    /// A filtered position is that of a filter on an endless line, in fractions of 1 ÷ 256: so it never overshoots, never
    /// jumps at the end of the range, and ends where the shaft stands.
    #[test]
    fn a_filter_goes_its_part_of_the_way(
        range in number(1 << 53),
        start in any::<u64>(),
        moves in proptest::collection::vec(-0.4f64..0.4, 1..20),
        strength in 0u8..=7,
    ) {
        let mut filter = Filter::new();
        filter.update(start % range, range, strength);
        let mut position = i128::from(start % range);
        let mut place = position * 256;
        let circle = i128::from(range);
        for part in moves {
            #[expect(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "any move will do")]
            let steps = (part * range as f64) as i128;
            // No further than half of the circle from where the filter is: there it would turn round.
            if 2 * ((position + steps) * 256 - place).abs() < (circle - 2) * 256 {
                position += steps;
            }
            place += (position * 256 - place) >> strength;
            let expected = (place + 128).div_euclid(256).rem_euclid(circle);
            let on_circle = u64::try_from(position.rem_euclid(circle)).expect("on the circle");
            prop_assert_eq!(i128::from(filter.update(on_circle, range, strength)), expected);
        }
        let on_circle = u64::try_from(position.rem_euclid(circle)).expect("on the circle");
        for _ in 0..6000 {
            filter.update(on_circle, range, strength);
        }
        prop_assert_eq!(filter.update(on_circle, range, strength), on_circle);
    }

    /// However it turns, over the end of its revolutions too, the position is that of the model.
    #[test]
    fn a_position_never_jumps(
        resolution in number(u32::MAX.into()),
        revolutions in number(1 << 40),
        units in number(u32::MAX.into()),
        more in any::<u64>(),
        is_counterclockwise in any::<bool>(),
        is_scaled in any::<bool>(),
        preset in any::<u64>(),
        start in any::<u64>(),
        moves in proptest::collection::vec(-1.0f64..1.0, 1..20),
    ) {
        let revolutions = revolutions.min(u64::MAX / resolution);
        let steps = i128::from(resolution) * i128::from(revolutions);
        prop_assume!(steps > 2);
        let range = units.max(more >> (more & 63));
        let parameters = Parameters {
            is_counterclockwise,
            is_scaled,
            units_per_revolution: u32::try_from(units).unwrap(),
            range,
        };
        let shaft = Shaft::new(u32::try_from(resolution).unwrap(), revolutions).unwrap();
        let mut position = Position::new(shaft, parameters, 0).unwrap();
        let mut model = Model {
            steps: i128::from(start) % steps,
            resolution: resolution.into(),
            units: if is_scaled { units.into() } else { resolution.into() },
            range: if is_scaled { range.into() } else { steps },
            offset: 0,
        };
        let revolutions = i128::from(revolutions);
        // The encoder's first reading is in its first round, whichever way it counts.
        if is_counterclockwise && model.steps != 0 {
            model.steps -= steps;
        }
        prop_assert_eq!(i128::from(position.update(model.reading(revolutions))), model.position(is_counterclockwise));
        let preset = preset % u64::try_from(model.range).unwrap();
        position.preset(model.reading(revolutions), preset).unwrap();
        model.offset += i128::from(preset) - model.position(is_counterclockwise);
        for part in moves {
            #[expect(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "any number of steps will do")]
            let forward = (part * (steps / 2 - 1).min(1 << 50) as f64) as i128;
            model.steps += forward.clamp(-(steps - 1) / 2, (steps - 1) / 2);
            prop_assert_eq!(
                i128::from(position.update(model.reading(revolutions))),
                model.position(is_counterclockwise)
            );
        }
    }

    #[test]
    fn a_speed_is_the_change_in_a_second(difference in any::<i32>(), millis in 1u32.., multiplier in any::<u16>(), divisor in 1u16..) {
        let exact = i128::from(difference) * 1000 * i128::from(multiplier) / (i128::from(millis) * i128::from(divisor));
        let nearest = exact.clamp(i32::MIN.into(), i32::MAX.into());
        prop_assert_eq!(i128::from(speed(difference, millis, multiplier, divisor)), nearest);
    }

    /// A cam is a set of positions, walked from its low limit to its high limit; hysteresis adds as many on both sides.
    #[test]
    fn a_cam_is_active_on_its_positions_and_leaves_them_late(
        range in 1u64..40,
        low in -50i32..50,
        high in -50i32..50,
        hysteresis in 0u32..50,
        position in 0u64..40,
    ) {
        let position = position % range;
        let circle = i64::try_from(range).unwrap();
        let walk = |from: i64, to: i64| {
            let mut at = from.rem_euclid(circle);
            let mut passed = vec![at];
            while at != to.rem_euclid(circle) {
                at = (at + 1) % circle;
                passed.push(at);
            }
            passed
        };
        let cam = Cam { low, high, hysteresis };
        let inside = walk(low.into(), high.into());
        let is_inside = inside.contains(&i64::try_from(position).unwrap());
        prop_assert_eq!(cam.is_active(false, position, range), is_inside);
        let near = inside.iter().any(|at| {
            let ahead = (i64::try_from(position).unwrap() - at).rem_euclid(circle);
            ahead.min(circle - ahead) <= i64::from(hysteresis)
        });
        prop_assert_eq!(cam.is_active(true, position, range), near);
    }

    #[test]
    fn an_area_says_on_which_side_the_position_is(low in any::<i32>(), high in any::<i32>(), position in any::<i64>()) {
        let limits = Area { low, high, minimum: i32::MIN, maximum: i32::MAX };
        let state = area(&limits, position);
        prop_assert_eq!(state & 0x02 != 0, i128::from(position) > i128::from(high));
        prop_assert_eq!(state & 0x04 != 0, i128::from(position) < i128::from(low));
    }
}

/// The WDGA after power-on: 16 bits a revolution (4000h steps), 16 bits of revolutions, not scaled.
fn wdga() -> Position {
    let shaft = Shaft::new(0x4000, 0x1_0000).expect("30 bits");
    let parameters = Parameters {
        is_counterclockwise: false,
        is_scaled: true,
        units_per_revolution: 0x4000,
        range: 0x4000_0000,
    };
    Position::new(shaft, parameters, 0).expect("its defaults")
}

#[test]
fn the_preset_is_what_is_read_where_it_is_written() {
    let mut position = wdga();
    let here = Reading { turn: 3, angle: 100 };
    assert_eq!(position.update(here), 3 * 0x4000 + 100);
    position.preset(here, 1000).expect("within the range");
    assert_eq!(position.update(here), 1000);
    assert_eq!(position.offset(), 1000 - (3 * 0x4000 + 100));
    assert_eq!(position.update(Reading { turn: 3, angle: 99 }), 999);
    assert_eq!(position.preset(here, 0x4000_0000), Err(AbortCode::VALUE_TOO_HIGH));
    assert_eq!(position.update(here), 1000);
}

#[test]
fn the_offset_and_the_base_outlive_power_off() {
    let parameters = Parameters {
        is_counterclockwise: true,
        is_scaled: true,
        units_per_revolution: 3600,
        range: 10_001,
    };
    let shaft = Shaft::new(1 << 14, 16).expect("18 bits");
    let mut position = Position::new(shaft, parameters, 0).expect("a range of more than a revolution");
    position
        .preset(Reading { turn: 15, angle: 5 }, 77)
        .expect("within the range");
    position.update(Reading { turn: 2, angle: 5 });
    let before = position.update(Reading { turn: 5, angle: 9 });
    let mut again = Position::new(shaft, parameters, position.memory()).expect("as before");
    again.set_offset(position.offset());
    assert_eq!(again.update(Reading { turn: 5, angle: 9 }), before);
}

#[test]
fn a_range_below_a_revolution_is_refused() {
    for (units_per_revolution, range) in [(0, 10), (100, 99), (1, 0)] {
        let parameters = Parameters {
            is_counterclockwise: false,
            is_scaled: true,
            units_per_revolution,
            range,
        };
        assert_eq!(parameters.check(), Err(AbortCode::VALUE_TOO_LOW));
    }
}

/// CiA 406, 8.2.1 to 8.2.3, and the WDGA's tables 7.13 to 7.16: cam 1 is bit 0; disabled cams are 0; polarity inverts.
#[test]
fn the_cam_state_register_has_a_bit_a_cam() {
    let cam = |low, high| Cam {
        low,
        high,
        hysteresis: 0,
    };
    let mut cams = [cam(500, 600); 8];
    (cams[0], cams[3], cams[7]) = (cam(0, 100), cam(50, 150), cam(-10, 60));
    let mut channel = Cams::new();
    assert_eq!(channel.update(&cams, 0xFF, 0x00, 55, 0x4000), 0x89);
    assert_eq!(channel.update(&cams, 0xFF, 0x00, 20, 0x4000), 0x81);
    assert_eq!(channel.update(&cams, 0x4A, 0x00, 20, 0x4000), 0x00);
    assert_eq!(channel.update(&cams, 0xFF, 0x13, 20, 0x4000), 0x92);
    assert_eq!(channel.update(&cams, 0xFF, 0x00, 0x3FFF, 0x4000), 0x80);
}

#[test]
fn the_area_state_is_that_of_the_manuals() {
    let limits = Area {
        low: 0,
        high: 0x4000,
        minimum: i32::MIN,
        maximum: 0x1_0000,
    };
    for (position, state) in [(0, 0x00), (0x4000, 0x00), (0x4001, 0x03), (-1, 0x05), (0x1_0001, 0x03)] {
        assert_eq!(area(&limits, position), state, "{position}");
    }
}
