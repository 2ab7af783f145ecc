//! What the LEDs show (3, tables 1 to 5).

use crate::device::{Bus, Client, delivered};
use lexican_runtime::{BusState, led::Pattern, profile::encoder::Faults};
use lexican_wv58mr::ErrorCounters;

fn shown(bus: &mut Bus) -> [Pattern; 3] {
    let leds = bus.slave().0.leds();
    [leds.device, leds.run, leds.error]
}

#[test]
fn the_run_led_shows_the_nmt_state() {
    let (mut bus, _) = delivered();
    assert_eq!(shown(&mut bus), [Pattern::Off, Pattern::Blinking, Pattern::Off]);
    bus.send("000#0101");
    assert_eq!(shown(&mut bus)[1], Pattern::On);
    bus.send("000#0201");
    assert_eq!(shown(&mut bus)[1], Pattern::SingleFlash);
}

#[test]
fn the_device_led_is_lit_while_the_speed_is_too_high() {
    let (mut bus, shaft) = delivered();
    shaft.break_down(Faults::SPEED);
    bus.advance(1);
    assert_eq!(shown(&mut bus)[0], Pattern::On);
    shaft.break_down(Faults::NONE);
    bus.advance(1);
    assert_eq!(shown(&mut bus)[0], Pattern::Off);
}

#[test]
fn the_error_led_shows_the_worst_of_the_bus() {
    let (mut bus, _) = delivered();
    let mut counters = ErrorCounters {
        receive: 95,
        transmit: 95,
    };
    bus.slave().0.set_bus_state(BusState::Active, counters);
    assert_eq!(shown(&mut bus)[2], Pattern::Off);
    counters.receive = 96;
    bus.slave().0.set_bus_state(BusState::Active, counters);
    assert_eq!(shown(&mut bus)[2], Pattern::SingleFlash);
    bus.set(0x100C, 0, &[10, 0]).set(0x100D, 0, &[1]);
    bus.send("701#R1").advance(10);
    assert_eq!(shown(&mut bus)[2], Pattern::DoubleFlash);
    bus.slave().0.set_bus_state(BusState::Off, counters);
    assert_eq!(shown(&mut bus)[2], Pattern::On);
}

#[test]
fn both_flicker_in_the_configuration_state_of_lss() {
    let (mut bus, _) = delivered();
    bus.send("7E5#0401000000000000");
    assert_eq!(
        shown(&mut bus),
        [Pattern::Off, Pattern::Flickering, Pattern::Flickering]
    );
    bus.send("7E5#0400000000000000");
    assert_eq!(shown(&mut bus)[1], Pattern::Blinking);
}
