//! Who is alive: heartbeats of others, node guarding, TIME, start-up and what errors do to the NMT state (CiA 301, 7.2.6, 7.2.8,
//! 7.5.2.11 to 7.5.2.28; the WDGA's manual, chapters 5.5 and 7.3 to 7.10).

use lexican_runtime::{BusState, Event, Heard, NmtState, NodeId, od::TimeOfDay};
use lexican_tests::{
    bus::Bus,
    generated::{
        wdga::{Device, Dictionary, Handlers},
        wv58mr,
    },
    simulated::{Object, Simulated},
};

/// Keeps what it is told of others.
#[derive(Default)]
struct Listener {
    told: Vec<Event>,
}

impl Handlers for Listener {
    fn event(&mut self, _: &mut Dictionary, event: Event) {
        if !matches!(event, Event::State(_)) {
            self.told.push(event);
        }
    }
}

/// A WDGA at node-ID 1, as its manual's examples have it.
fn wdga() -> Bus<Device<Listener>> {
    Bus::booted(Device::new(Listener::default()), 1)
}

fn told(bus: &mut Bus<Device<Listener>>) -> Vec<Event> {
    std::mem::take(&mut bus.node().device_mut().handlers.told)
}

fn heartbeat(node_id: u8, heard: Heard) -> Event {
    let node_id = NodeId::new(node_id).expect("1 to 127");
    Event::Heartbeat { node_id, heard }
}

/// Watches node 10 for 100 ms.
const WATCH: &str = "601#2316100164000A00";
const WATCHES: &str = "581#6016100100000000";
const LOST: &str = "081#308111.0A00000000";
const FOUND: &str = "081#0000000000000000";

fn watching() -> Bus<Device<Listener>> {
    let mut bus = wdga();
    bus.send(WATCH).expect(WATCHES).silence();
    bus
}

#[test]
fn a_node_that_was_never_heard_is_not_missed() {
    let mut bus = watching();
    bus.advance(10_000).silence();
    bus.send("70A#00").advance(10_000).silence();
    assert_eq!(told(&mut bus), [heartbeat(10, Heard::BootUp)]);
}

#[test]
fn a_node_that_falls_silent_is_told_and_told_again_when_it_is_back() {
    let mut bus = watching();
    bus.send("70A#05").advance(99).silence();
    bus.send("70A#05").advance(99).silence();
    bus.advance(1).expect(LOST).silence();
    bus.advance(10_000).silence();
    bus.send("70A#04").expect(FOUND).silence();
    assert_eq!(
        told(&mut bus),
        [
            heartbeat(10, Heard::State(NmtState::Operational)),
            heartbeat(10, Heard::Nothing),
            heartbeat(10, Heard::State(NmtState::Stopped)),
        ]
    );
}

#[test]
fn a_watched_node_that_boots_up_and_never_speaks_again_is_missed() {
    let mut bus = watching();
    bus.send("70A#05").send("70A#00").advance(100).expect(LOST);
}

#[test]
fn others_heartbeats_mean_nothing() {
    let mut bus = watching();
    bus.send("70B#05")
        .send("701#05")
        .send("700#05")
        .send("70A#0505")
        .send("70A#06");
    bus.advance(10_000).silence();
    assert_eq!(told(&mut bus), []);
}

#[test]
fn the_watch_ends_with_its_parameter_and_with_a_reset() {
    let mut bus = watching();
    bus.send("70A#05").send("601#2316100100000000").expect(WATCHES);
    bus.advance(10_000).silence();
    let mut bus = watching();
    bus.send("70A#05")
        .send("000#8201")
        .expect("701#00")
        .advance(10_000)
        .silence();
}

#[test]
fn a_lost_heartbeat_takes_the_node_out_of_operational_as_1029h_says() {
    for (behaviour, state) in [
        ("00", NmtState::PreOperational),
        ("01", NmtState::Operational),
        ("02", NmtState::Stopped),
    ] {
        let mut bus = watching();
        bus.send(&format!("601#2F291001{behaviour}000000"))
            .expect("581#6029100100000000");
        bus.send("000#0101").send("70A#05").advance(100);
        assert_eq!(bus.node().state(), state, "1029h:01 = {behaviour}");
    }
}

#[test]
fn an_error_of_the_device_does_what_its_own_sub_index_says() {
    let mut bus = wdga();
    bus.send("601#2F29100202000000")
        .expect("581#6029100200000000")
        .send("000#0101");
    bus.node().react_to_error(2);
    assert_eq!(bus.node().state(), NmtState::Stopped);
}

#[test]
fn a_node_is_watched_by_one_sub_index_only() {
    simulated(&[(0x1016, 1, 4, 0), (0x1016, 2, 4, 0)])
        .send(WATCH)
        .expect(WATCHES)
        .send("601#23161002C8000A00")
        .expect("581#8016100243000406")
        .send("601#2316100200000A00")
        .expect("581#6016100200000000")
        .send(WATCH)
        .expect(WATCHES);
}

/// A device with these numbers: index, sub-index, bytes, default.
fn simulated(numbers: &[(u16, u8, usize, u64)]) -> Bus<Simulated> {
    Bus::booted(device(numbers), 1)
}

fn device(numbers: &[(u16, u8, usize, u64)]) -> Simulated {
    let objects = numbers
        .iter()
        .map(|&(index, sub, length, default)| Object::number(index, sub, length, default));
    Simulated::new(&objects.collect::<Vec<_>>())
}

#[test]
fn the_master_asks_for_the_state_and_the_answer_toggles() {
    let mut bus = Bus::booted(wv58mr::Device::new(()), 1);
    bus.send("601#2B0C1000F4010000").expect("581#600C100000000000");
    bus.send("601#2F0D100002000000").expect("581#600D100000000000");
    bus.send("701#R1").expect("701#7F").send("701#R1").expect("701#FF");
    bus.send("000#0201")
        .send("701#R1")
        .expect("701#04")
        .send("701#R1")
        .expect("701#84");
    bus.send("000#8201").expect("701#00").send("701#R1").expect("701#7F");
}

#[test]
fn who_is_not_guarded_does_not_answer() {
    simulated(&[(0x1000, 0, 4, 0)]).send("701#R1").silence();
    let mut producer = simulated(&[(0x100C, 0, 2, 500), (0x100D, 0, 1, 2), (0x1017, 0, 2, 1000)]);
    producer.send("701#R1").silence();
    producer.send("601#2B17100000000000").expect("581#6017100000000000");
    producer.send("701#R1").expect("701#7F").send("702#R1").silence();
}

/// Guarded every 500 ms, given up after 1000 ms.
const GUARDED: [(u16, u8, usize, u64); 4] = [
    (0x100C, 0, 2, 500),
    (0x100D, 0, 1, 2),
    (0x1014, 0, 4, 0x81),
    (0x1001, 0, 1, 0),
];

#[test]
fn a_master_that_stops_asking_is_missed_once_it_has_begun() {
    let mut bus = simulated(&GUARDED);
    bus.send("000#0101").advance(10_000).silence();
    bus.send("701#R1").expect("701#05").advance(999).silence();
    bus.send("701#R1").expect("701#85").advance(999).silence();
    bus.advance(1).expect("081#3081110000000000").silence();
    assert_eq!(bus.node().state(), NmtState::PreOperational);
    bus.advance(10_000).silence();
    bus.send("701#R1")
        .expect("701#7F")
        .expect("081#0000000000000000")
        .silence();
}

#[test]
fn a_life_time_of_nothing_guards_nothing() {
    let mut bus = simulated(&GUARDED);
    bus.send("601#2F0D100000000000").expect("581#600D100000000000");
    bus.send("701#R1").expect("701#7F").advance(100_000).silence();
    let mut bus = simulated(&GUARDED);
    bus.send("701#R1").expect("701#7F");
    bus.send("601#2F0D100000000000")
        .expect("581#600D100000000000")
        .advance(100_000)
        .silence();
}

#[test]
fn a_heartbeat_consumer_is_told_with_the_life_time_of_a_master() {
    let mut bus = wdga();
    bus.send("601#2B0C1000F4010000").expect("581#600C100000000000");
    bus.send("601#2F0D100002000000").expect("581#600D100000000000");
    bus.send("701#R1")
        .expect("701#7F")
        .advance(1000)
        .expect("081#3081110000000000");
    bus.send("701#R1").expect("701#FF").expect(FOUND);
    assert_eq!(
        told(&mut bus),
        [Event::LifeGuardingLost(true), Event::LifeGuardingLost(false)]
    );
}

#[test]
fn the_time_of_day_is_told_to_a_consumer() {
    let mut bus = simulated(&[(0x1012, 0, 4, 0x8000_0100)]);
    let noon = TimeOfDay::new(15_654, 12 * 3_600_000);
    bus.send("100#002E9302263D")
        .send("100#002E93022600")
        .send("100#002E930226")
        .send("101#002E9302263D");
    bus.send("601#2312100000010000")
        .expect("581#6012100000000000")
        .send("100#002E9302263D");
    let told: Vec<_> = bus
        .node()
        .device()
        .told()
        .iter()
        .filter_map(|event| match event {
            Event::Time(time) => Some(*time),
            _ => None,
        })
        .collect();
    assert_eq!(told, [noon, TimeOfDay::new(38, 12 * 3_600_000)]);
}

#[test]
fn an_identifier_of_time_is_changed_while_it_is_not_consumed() {
    simulated(&[(0x1012, 0, 4, 0x8000_0100)])
        .send("601#2312100000020080")
        .expect("581#8012100030000906")
        .send("601#2312100000010040")
        .expect("581#8012100030000906")
        .send("601#2312100002010000")
        .expect("581#8012100030000906")
        .send("601#2312100000010000")
        .expect("581#6012100000000000")
        .send("601#2312100000020080")
        .expect("581#6012100000000000");
}

#[test]
fn a_node_starts_itself_and_others_as_1f80h_says() {
    for (behaviour, state) in [
        (0x00, NmtState::PreOperational),
        (0x02, NmtState::Operational),
        (0x08, NmtState::Operational),
    ] {
        let mut bus = simulated(&[(0x1F80, 0, 4, behaviour)]);
        if behaviour == 0x02 {
            bus.expect("000#0100");
        }
        bus.silence();
        assert_eq!(bus.node().state(), state, "1F80h = {behaviour:02X}h");
    }
}

const BUS: [(u16, u8, usize, u64); 2] = [(0x1001, 0, 1, 0), (0x1014, 0, 4, 0x81)];

#[test]
fn a_controller_in_trouble_is_told_until_it_is_well() {
    let mut bus = simulated(&BUS);
    bus.node().set_bus_state(BusState::Passive);
    bus.node().set_bus_state(BusState::Passive);
    bus.advance(1).expect("081#2081110000000000").silence();
    bus.node().set_bus_state(BusState::Active);
    bus.advance(1).expect("081#0000000000000000").silence();
}

#[test]
fn a_bus_that_was_off_ends_operational_and_is_told_when_it_is_back() {
    let mut bus = simulated(&BUS);
    bus.send("000#0101");
    bus.node().set_bus_state(BusState::Off);
    assert_eq!(bus.node().state(), NmtState::PreOperational);
    bus.advance(1000).silence();
    bus.node().set_bus_state(BusState::Active);
    bus.advance(1)
        .expect("081#4081110000000000")
        .expect("081#0000000000000000")
        .silence();
}

#[test]
fn lost_frames_are_told() {
    let mut bus = simulated(&BUS);
    bus.node().report_overrun();
    bus.advance(1)
        .expect("081#1081110000000000")
        .expect("081#0000000000000000")
        .silence();
}
