//! The probe: 46 frames in a row to one node, which no other stack answers right all through.
//!
//! Frames for services of a later issue are sent too, but their answers are not judged: they are listed in [`LATER`].

use std::{fs, path::PathBuf};

use lexican_runtime::Frame;
use lexican_tests::{bus::Bus, line, simulated::Simulated};

/// What waits for LSS and node guarding.
const LATER: [&str; 4] = [
    "lss_inquire_vendor",
    "lss_inquire_nodeid",
    "lss_switch_global",
    "nmt_guard_rtr",
];

/// This client does not ask for a CRC, so it is not offered one: python-canopen would check it all the same, though it is 0
/// then (CiA 301, 7.2.4.3.15).
const WITHOUT_CRC: &str = "C2";

fn shared(file: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("../../shared")
        .join(file)
}

#[test]
#[expect(clippy::print_stdout, reason = "what was left out is to be seen")]
fn every_frame_of_the_probe_is_answered_right_whose_service_is_there() {
    let (Ok(probe), Ok(eds)) = (
        fs::read_to_string(shared("vectors/probe.tsv")),
        fs::read(shared("bench/bench_100.eds")),
    ) else {
        println!("no shared probe here: nothing was held");
        return;
    };
    let device = Simulated::of(&lexican_eds::read("bench_100.eds", eds).dictionary);
    let mut bus = Bus::booted(device, 0x10);
    let mut held = 0;
    for line in probe
        .lines()
        .filter(|line| !line.starts_with('#') && !line.starts_with("name\t"))
    {
        let [name, frame, right] = line.split('\t').collect::<Vec<_>>()[..] else {
            panic!("`{line}` has not three columns");
        };
        let answer = answer(bus.put(frame_of(frame)));
        let right = if name == "blk_up_init_1008" { WITHOUT_CRC } else { right };
        if LATER.contains(&name) {
            println!("later: {name} (answered {answer})");
            continue;
        }
        assert!(
            is_right(&answer, right),
            "{name}: {frame} was answered {answer}, right is {right}"
        );
        held += 1;
    }
    assert_eq!(held, 45, "fewer frames are answered right than were");
}

/// `610 40 ff 5f …`, or `710R`.
fn frame_of(text: &str) -> Frame {
    let (id, data) = text.split_once(' ').unwrap_or((text, ""));
    line::frame(&format!(
        "{}#{}{data}",
        id.trim_end_matches('R'),
        if id.ends_with('R') { "R" } else { "" }
    ))
}

/// An abort code, the first byte, or `-` for silence.
fn answer(bus: &mut Bus<Simulated>) -> String {
    let heartbeat = |frame: &Frame| frame.id().number() >= 0x700;
    match std::iter::from_fn(|| bus.take()).find(|frame| !heartbeat(frame)) {
        None => "-".to_owned(),
        Some(frame) => match frame.data() {
            &[0x80, _, _, _, a, b, c, d] => format!("{:08X}", u32::from_le_bytes([a, b, c, d])),
            data => data.first().map_or_else(String::new, |byte| format!("{byte:02X}")),
        },
    }
}

/// Right answers stand between bars, some with a remark in brackets behind them.
fn is_right(answer: &str, right: &str) -> bool {
    right
        .split('|')
        .any(|right| right.split_whitespace().next() == Some(answer))
}
