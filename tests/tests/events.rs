//! What an application is told beside the accesses to its objects.

use lexican_runtime::{Event, NmtState, Reset};
use lexican_tests::{
    bus::Bus,
    generated::wdga::{Device, Dictionary, Handlers},
};

/// Keeps what it is told.
#[derive(Default)]
struct Listener {
    told: Vec<Event>,
}

impl Handlers for Listener {
    fn event(&mut self, od: &mut Dictionary, event: Event) {
        if event == Event::Reset(Reset::Node) {
            od.position_value = 0;
        }
        self.told.push(event);
    }
}

impl Listener {
    fn take(&mut self) -> Vec<Event> {
        std::mem::take(&mut self.told)
    }
}

fn bus() -> Bus<Device<Listener>> {
    Bus::booted(Device::new(Listener::default()), 1)
}

fn told(bus: &mut Bus<Device<Listener>>) -> Vec<Event> {
    bus.node().device_mut().handlers.take()
}

#[test]
fn the_application_is_told_each_new_state_once() {
    let mut bus = bus();
    assert_eq!(told(&mut bus), [Event::State(NmtState::PreOperational)]);
    bus.send("000#0101").send("000#0100");
    assert_eq!(told(&mut bus), [Event::State(NmtState::Operational)]);
    bus.send("000#0201").send("000#8001");
    assert_eq!(
        told(&mut bus),
        [Event::State(NmtState::Stopped), Event::State(NmtState::PreOperational)]
    );
}

#[test]
fn a_reset_is_told_before_the_boot_up_and_the_application_resets_its_own_values() {
    let mut bus = bus();
    bus.node().device_mut().od.position_value = 1234;
    bus.send("000#8201").expect("701#00");
    assert_eq!(bus.node().device().od.position_value, 1234);
    bus.send("000#8101").expect("701#00");
    assert_eq!(bus.node().device().od.position_value, 0);
    let state = Event::State(NmtState::PreOperational);
    assert_eq!(
        told(&mut bus),
        [
            state,
            Event::Reset(Reset::Communication),
            state,
            Event::Reset(Reset::Node),
            state
        ]
    );
}
