//! python-canopen as LSS master: it finds a slave without a node-ID, configures it, and selects it again.

use lexican_runtime::{Node, NodeId, lss::BitRate};
use lexican_tests::{
    bus::Bus,
    memory::Memory,
    python,
    simulated::{Object, Simulated},
};

const IDENTITY: [u32; 4] = [0x13F, 0x5744_4741, 0x0001_0002, 0xBEEF_0001];

fn device(memory: &Memory) -> Simulated {
    let subs = (1..).zip(IDENTITY);
    let objects: Vec<Object> = subs
        .map(|(sub, number)| Object::number(0x1018, sub, 4, number.into()))
        .collect();
    Simulated::new(&objects).with_memory(memory)
}

#[test]
fn python_canopen_finds_configures_and_selects_a_slave() {
    let Some(python) = python::with_canopen() else { return };
    let memory = Memory::flash(64);
    let mut bus = Bus::of(Node::unconfigured(device(&memory)));
    let identity = IDENTITY.map(|number| format!("{number:X}"));
    let frames = python::talk(&mut bus, &python, "lss_master.py", identity);
    // A fastscan has 133 questions.
    assert!(frames > 133, "{frames} frames");
    bus.advance(20).silence();
    assert_eq!(bus.node().node_id(), NodeId::new(42));
    assert_eq!(bus.node().bit_rate(), Some(BitRate::KBIT_500));
    let mut after_power_off = Bus::of(Node::unconfigured(device(&memory)));
    after_power_off.advance(0).expect("72A#00");
}
