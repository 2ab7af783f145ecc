//! NMT states and commands, boot-up and heartbeat (CiA 301, 7.2.8 and 7.3.2).

use lexican_runtime::{Instant, NmtState, Node, NodeId};
use lexican_tests::{
    bus::Bus,
    sample::{Quiet, device::Device, quiet},
};

const READ: &str = "601#4000100000000000";
const ANSWER: &str = "581#4300100096010200";

fn bus() -> Bus<Device<Quiet>> {
    Bus::booted(quiet(), 1)
}

#[test]
fn a_node_boots_up_by_itself_into_pre_operational() {
    let mut bus = Bus::new(quiet(), 127);
    assert_eq!(bus.node().state(), NmtState::Initialising);
    bus.advance(0).expect("77F#00").advance(10_000).silence();
    assert_eq!(bus.node().state(), NmtState::PreOperational);
}

#[test]
fn a_node_that_has_not_booted_up_answers_nothing() {
    let now = Instant::from_millis(1);
    let mut node = Node::new(quiet(), NodeId::new(1).unwrap());
    node.receive(now, &lexican_tests::line::frame(READ));
    node.receive(now, &lexican_tests::line::frame("000#0101"));
    assert_eq!(node.poll(now), Some(lexican_tests::line::frame("701#00")));
    assert_eq!(node.poll(now), None);
    assert_eq!(node.state(), NmtState::PreOperational);
}

#[test]
fn commands_to_the_node_and_to_all_are_obeyed() {
    let mut bus = bus();
    for node in ["01", "00"] {
        for (command, state) in [
            ("01", NmtState::Operational),
            ("02", NmtState::Stopped),
            ("80", NmtState::PreOperational),
            ("02", NmtState::Stopped),
            ("01", NmtState::Operational),
        ] {
            bus.send(&format!("000#{command}{node}")).silence();
            assert_eq!(bus.node().state(), state, "{command} to {node}");
        }
    }
}

#[test]
fn commands_to_others_and_what_is_no_command_are_ignored() {
    let mut bus = bus();
    for frame in ["000#0102", "000#5501", "000#01", "000#", "000#R2", "00000000#0101"] {
        bus.send(frame).silence();
        assert_eq!(bus.node().state(), NmtState::PreOperational, "{frame}");
    }
}

#[test]
fn sdos_are_served_in_pre_operational_and_operational_only() {
    bus()
        .send(READ)
        .expect(ANSWER)
        .send("000#0101")
        .send(READ)
        .expect(ANSWER)
        .send("000#0201")
        .send(READ)
        .silence()
        .send("000#8001")
        .send(READ)
        .expect(ANSWER);
}

#[test]
fn stopping_ends_a_transfer() {
    bus()
        .send("601#4008100000000000")
        .expect("581#410810000E000000")
        .send("000#0201")
        .advance(10_000)
        .silence()
        .send("000#0101")
        .send("601#6000000000000000")
        .expect("581#8000000001000405");
}

#[test]
fn a_reset_boots_the_node_up_again_from_every_state() {
    for command in ["01", "02", "80"] {
        for reset in ["81", "82"] {
            let mut bus = bus();
            bus.send(&format!("000#{command}01"))
                .send(&format!("000#{reset}00"))
                .expect("701#00")
                .send(READ)
                .expect(ANSWER);
            assert_eq!(bus.node().state(), NmtState::PreOperational);
        }
    }
}

#[test]
fn reset_communication_restores_1000h_to_1fffh() {
    bus()
        .send("601#2B17100010270000")
        .expect("581#6017100000000000")
        .expect("701#7F")
        .send("601#23141000FF060080")
        .expect("581#6014100000000000")
        .send("601#2B00620034120000")
        .expect("581#6000620000000000")
        .send("000#8201")
        .expect("701#00")
        .advance(60_000)
        .silence() // no heartbeat any more
        .send("601#4014100000000000")
        .expect("581#4314100081000000")
        .send("601#4000620000000000")
        .expect("581#4B00620034120000");
}

#[test]
fn reset_node_restores_what_a_client_may_write_and_leaves_the_applications_own() {
    let mut bus = bus();
    bus.node().device_mut().od.error_register = 0x81;
    bus.send("601#2B00620034120000")
        .expect("581#6000620000000000")
        .send("601#2B09200068690000")
        .expect("581#6009200000000000")
        .send("000#8101")
        .expect("701#00")
        .send("601#4000620000000000")
        .expect("581#4B00620000000000")
        .send("601#4009200000000000")
        .expect("581#4709200074616700")
        .send("601#4001100000000000")
        .expect("581#4F01100081000000");
}

#[test]
fn a_new_node_id_is_used_from_its_boot_up_on() {
    let mut bus = bus();
    bus.node().set_node_id(NodeId::new(0x20).unwrap());
    bus.advance(0)
        .expect("720#00")
        .send(READ)
        .silence()
        .send("620#4000120100000000")
        .expect("5A0#4300120120060000");
}

#[test]
fn the_heartbeat_begins_when_it_is_configured_and_tells_the_state() {
    bus()
        .send("601#2B17100064000000") // 100 ms
        .expect("581#6017100000000000")
        .expect("701#7F")
        .advance(99)
        .silence()
        .advance(1)
        .expect("701#7F")
        .send("000#0101")
        .advance(100)
        .expect("701#05")
        .send("000#0201")
        .advance(100)
        .expect("701#04");
}

#[test]
fn a_new_heartbeat_time_takes_effect_at_once_and_zero_ends_it() {
    bus()
        .send("601#2B171000E8030000")
        .expect("581#6017100000000000")
        .expect("701#7F")
        .advance(500)
        .send("601#2B17100032000000") // 50 ms
        .expect("581#6017100000000000")
        .expect("701#7F")
        .advance(100)
        .expect("701#7F")
        .expect("701#7F")
        .silence()
        .send("601#2B17100000000000")
        .expect("581#6017100000000000")
        .advance(10_000)
        .silence();
}

#[test]
fn the_boot_up_message_is_the_first_heartbeat_of_a_node_that_is_configured_for_one() {
    let mut device = quiet();
    device.od.producer_heartbeat_time = 100;
    Bus::booted(device, 1)
        .advance(99)
        .silence()
        .advance(1)
        .expect("701#7F")
        .silence();
}

#[test]
fn the_application_may_set_the_heartbeat_time_too() {
    let mut bus = bus();
    bus.node().device_mut().od.producer_heartbeat_time = 100;
    bus.advance(150).expect("701#7F").expect("701#7F").silence();
}

#[test]
fn a_late_poll_neither_drops_the_beat_nor_sends_it_twice() {
    let mut node = Node::new(quiet(), NodeId::new(1).unwrap());
    node.device_mut().od.producer_heartbeat_time = 100;
    let at = Instant::from_millis;
    assert!(node.poll(at(0)).is_some(), "boot-up");
    assert_eq!(node.poll_at(), Some(at(100)));
    assert!(node.poll(at(130)).is_some());
    assert_eq!(node.poll_at(), Some(at(200)), "the beat is kept");
    assert!(node.poll(at(1000)).is_some());
    assert_eq!(node.poll(at(1000)), None);
    assert_eq!(node.poll_at(), Some(at(1100)), "what was missed is missed");
}

#[test]
fn an_idle_node_asks_for_no_poll() {
    assert_eq!(bus().node().poll_at(), None);
}

#[test]
fn at_the_end_of_time_a_timer_that_does_not_run_is_still_not_due() {
    let end = Instant::from_micros(u64::MAX);
    let mut node = Node::new(quiet(), NodeId::new(1).unwrap());
    assert!(node.poll(end).is_some(), "boot-up");
    assert_eq!(node.poll(end), None);
    assert_eq!(node.poll(Instant::from_millis(u64::MAX)), None);
}
