//! The firmware of `examples/firmware` on an emulated Cortex-M4. `examples/firmware/run` builds it and runs these.

#![cfg(unix)]

use std::{fs, path::Path};

use lexican_eds::{
    dump,
    ir::{AccessType, Dictionary, Entry, NodeId},
};
use lexican_runtime as runtime;
use lexican_tests::{
    corpus::notice,
    emulator::Emulator,
    sdo_client::{Step, Upload},
};

/// The node-ID that the device is delivered with.
const NODE_ID: u8 = 0x7F;
/// What the firmware's start fills the stack with.
const PAINT: [u8; 4] = [0xCC; 4];
/// What `docs/performance.md` states of the stack, in bytes: to make the node and put it in its place, and from then on.
const STACK_TO_START: usize = 3072;
const STACK_TO_RUN: usize = 1536;

fn dictionary() -> Dictionary {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../eds/devices/wdga.eds");
    lexican_eds::read("wdga.eds", fs::read(path).expect("a file of the project")).dictionary
}

/// Asks the adapter what it is, and goes on the bus; the node boots.
fn boot(device: &mut Emulator) {
    device
        .command("", "\r")
        .command("V", "V1010\r")
        .command("N", "NWDGA\r")
        .command("C", "\x07")
        .command("t0800", "\x07")
        .command("S6", "\r")
        .command("O", "\r")
        .expect("77F#00")
        .command("O", "\x07")
        .command("S6", "\x07")
        .command("nonsense", "\x07")
        .command("F", "F00\r");
}

/// Every object that can be read has its default value; of the errors there are none.
fn upload_everything(device: &mut Emulator) {
    let dictionary = dictionary();
    let mut count = 0;
    for entry in dictionary.entries().filter(|entry| entry.access != AccessType::Wo) {
        let answer = upload(device, entry);
        assert_eq!(answer, expected(entry), "{}\n{device:?}", entry.address);
        count += 1;
    }
    assert!(count > 200, "{count}");
}

/// After power-on: no error has occurred, so that the history has no data (CiA 301, 7.5.2.4).
fn expected(entry: &Entry) -> dump::Answer {
    match (entry.address.index, entry.address.sub) {
        (0x1003, 1..) => dump::Answer::Abort(dump::AbortCode(0x0800_0024)),
        _ => dump::Answer::Value(default(entry)),
    }
}

/// On the bus; zero or empty where the file gives none.
fn default(entry: &Entry) -> Vec<u8> {
    match &entry.default {
        Some(default) => default.to_bytes(entry.data_type, NodeId::new(NODE_ID)),
        None => vec![0; entry.data_type.bytes().unwrap_or(0)],
    }
}

fn upload(device: &mut Emulator, entry: &Entry) -> dump::Answer {
    let node_id = runtime::NodeId::new(NODE_ID).expect("a node-ID");
    let address = runtime::Address::new(entry.address.index, entry.address.sub);
    let (mut upload, mut request) = Upload::begin(node_id, address);
    loop {
        device.put(&request);
        match upload.receive(&device.take().0) {
            Step::Send(next) => request = next,
            Step::Done(answer) => return answer,
            other => panic!("{other:?}\n{device:?}"),
        }
    }
}

/// A preset moves the position, and TPDO 2 tells it on SYNC, in OPERATIONAL only.
fn exchange_pdos(device: &mut Emulator) {
    device
        .send("67F#2303600044332211")
        .expect("5FF#6003600000000000")
        .send("080#")
        .send("000#017F")
        .send("080#")
        .expect("2FF#44332211")
        .expect("3FF#0000000000000000");
}

/// Every command, from whichever state, addressed to the node or to all.
fn obey_nmt(device: &mut Emulator) {
    let read_state = "67F#4005100000000000";
    let state = "5FF#4305100080000000";
    device
        .send("000#0200")
        // STOPPED: no SDO; the answer that comes is the second request's.
        .send("67F#4000100000000000")
        .send("000#807F")
        .send(read_state)
        .expect(state)
        // Another node's.
        .send("000#8101")
        .send(read_state)
        .expect(state)
        .send("000#8200")
        .expect("77F#00")
        .send("67F#4003600000000000")
        .expect("5FF#4303600044332211")
        .send("000#817F")
        .expect("77F#00")
        .send("67F#4003600000000000")
        .expect("5FF#4303600000000000");
}

/// What is saved is there after a reset, until the defaults are asked for.
fn store(device: &mut Emulator) {
    let preset = |value: &str| format!("5FF#43036000{value}");
    device
        .send("67F#2303600055000000")
        .expect("5FF#6003600000000000")
        .send("67F#2310100173617665")
        .expect("5FF#6010100100000000")
        .send("000#817F")
        .expect("77F#00")
        .send("67F#4003600000000000")
        .expect(&preset("55000000"))
        .send("67F#231110016C6F6164")
        .expect("5FF#6011100100000000")
        .send("000#817F")
        .expect("77F#00")
        .send("67F#4003600000000000")
        .expect(&preset("00000000"));
}

/// An LSS master selects the device by its identity, gives it node-ID 5, and it boots under it.
fn be_configured(device: &mut Emulator) {
    device
        .send("7E5#401F020001000000")
        .send("7E5#4141474457000000")
        .send("7E5#4208020603000000")
        .send("7E5#4300000000000000")
        .expect("7E4#4400000000000000")
        .send("7E5#5E00000000000000")
        .expect("7E4#5E7F000000000000")
        .send("7E5#1105000000000000")
        .expect("7E4#1100000000000000")
        .send("7E5#1700000000000000")
        .expect("7E4#1700000000000000")
        .send("7E5#0400000000000000")
        .send("000#827F")
        .expect("705#00")
        .send("605#4000100000000000")
        .expect("585#4300100096010200");
}

/// A heartbeat every 100 ms of the firmware's own clock.
fn beat(device: &mut Emulator) {
    device
        .command("C", "\r")
        .command("Z1", "\r")
        .command("O", "\r")
        .send("67F#2B17100064000000");
    let mut times = Vec::new();
    while times.len() < 4 {
        let (frame, time) = device.take();
        if format!("{frame:?}") == "77F#7F" {
            times.push(time.expect("Z1 was set"));
        }
    }
    let steps = times.windows(2).map(|pair| (60_000 + pair[1] - pair[0]) % 60_000);
    assert!(
        steps.clone().all(|step| (99..=101).contains(&step)),
        "{times:?}\n{device:?}"
    );
}

#[test]
fn it_boots_when_its_adapter_goes_on_the_bus() {
    let Some(mut device) = Emulator::start("boot") else {
        return;
    };
    boot(&mut device);
}

#[test]
fn every_object_of_the_eds_has_its_default_value() {
    let Some(mut device) = Emulator::booted("upload") else {
        return;
    };
    upload_everything(&mut device);
}

#[test]
fn a_sync_brings_the_position_in_operational() {
    let Some(mut device) = Emulator::booted("sync") else {
        return;
    };
    exchange_pdos(&mut device);
}

#[test]
fn nmt_is_obeyed_and_a_reset_node_has_its_defaults_again() {
    let Some(mut device) = Emulator::booted("nmt") else {
        return;
    };
    exchange_pdos(&mut device);
    obey_nmt(&mut device);
}

#[test]
fn the_heartbeat_keeps_time() {
    let Some(mut device) = Emulator::booted("heartbeat") else {
        return;
    };
    beat(&mut device);
}

#[test]
fn what_is_saved_outlives_a_reset() {
    let Some(mut device) = Emulator::booted("store") else {
        return;
    };
    store(&mut device);
}

#[test]
fn lss_gives_it_another_node_id() {
    let Some(mut device) = Emulator::booted("lss") else {
        return;
    };
    be_configured(&mut device);
}

#[test]
fn a_burst_of_requests_loses_no_byte() {
    let Some(mut device) = Emulator::booted("burst") else {
        return;
    };
    device.burst("t67F84005100000000000\r", 100);
    for _ in 0..100 {
        device.expect_sent().expect("5FF#4305100080000000");
    }
    device.command("F", "F00\r");
}

#[test]
fn all_of_this_needs_no_more_stack_than_is_documented() {
    let Some(mut device) = Emulator::start("stack") else {
        return;
    };
    let started = device.ram();
    boot(&mut device);
    upload_everything(&mut device);
    exchange_pdos(&mut device);
    obey_nmt(&mut device);
    store(&mut device);
    beat(&mut device);
    be_configured(&mut device);
    let ended = device.ram();
    let (to_start, to_run) = (painted_over(&started), written_since(&started, &ended));
    notice(&format!("stack: {to_start} bytes to start, {to_run} to run"));
    assert!((64..=STACK_TO_START).contains(&painted_over(&ended)), "{to_start}");
    assert!((64..=STACK_TO_RUN).contains(&to_run), "{to_run}");
}

/// How much of the RAM's end is no longer as the firmware's start painted it. What lies between the statics and the stack's
/// deepest word is the longest run of paint: a function may leave some of its own room as it was.
fn painted_over(ram: &[u8]) -> usize {
    let words: Vec<bool> = ram.chunks_exact(4).map(|word| word == PAINT).collect();
    let runs = words.chunk_by(|one, other| one == other);
    let ends = runs.clone().scan(0, |end, run| {
        *end += run.len();
        Some(*end)
    });
    let painted = runs.zip(ends).filter(|(run, _)| run[0]);
    let (_, end) = painted.max_by_key(|(run, _)| run.len()).expect("a painted word");
    4 * (words.len() - end)
}

/// How much of the RAM's end is no longer as it was when the firmware had started: what is below the paint are statics.
fn written_since(started: &[u8], ended: &[u8]) -> usize {
    let top = ended.len() - painted_over(ended);
    let mut pairs = started[top..].iter().zip(&ended[top..]);
    let untouched = pairs
        .position(|(before, after)| before != after)
        .expect("something ran");
    ended.len() - top - untouched
}
