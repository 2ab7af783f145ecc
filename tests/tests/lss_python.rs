//! python-canopen as LSS master: it finds a slave without a node-ID, configures it, and selects it again.

use std::{
    io::{BufRead, BufReader, Write},
    path::Path,
    process::{Command, Stdio},
};

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
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("oracle/lss_master.py");
    let mut master = Command::new(python)
        .arg(script)
        .args(IDENTITY.map(|number| format!("{number:X}")))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut answers = master.stdin.take().unwrap();
    let mut frames = 0;
    for frame in BufReader::new(master.stdout.take().unwrap()).lines() {
        bus.send(&frame.unwrap());
        while let Some(answer) = bus.take() {
            writeln!(answers, "{answer:?}").unwrap();
        }
        writeln!(answers, ".").unwrap();
        frames += 1;
    }
    assert!(master.wait().unwrap().success());
    // A fastscan has 133 questions.
    assert!(frames > 133, "{frames} frames");
    bus.advance(20).silence();
    assert_eq!(bus.node().node_id(), NodeId::new(42));
    assert_eq!(bus.node().bit_rate(), Some(BitRate::KBIT_500));
    let mut after_power_off = Bus::of(Node::unconfigured(device(&memory)));
    after_power_off.advance(0).expect("72A#00");
}
