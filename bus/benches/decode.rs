//! What decoding a log costs: `cargo bench -p lexican-bus --bench decode`, on one core, from text to text.
//!
//! The log is made up: of ten frames seven are PDOs of four nodes, one is a heartbeat, two are an SDO upload and its answer.
//! `-- --once FRAMES` decodes that many once and prints nothing, for callgrind.
#![expect(
    clippy::print_stdout,
    clippy::cast_precision_loss,
    reason = "a bench prints its figures"
)]

use std::{
    fmt::Write as _,
    hint::black_box,
    time::{Duration, Instant},
};

use lexican_bus::{
    decode::{Decoder, Description, write_json, write_text},
    log::{Reader, Record},
};
use lexican_eds::Reading;

const FRAMES: usize = 1_000_000;
/// Read at run time: a package includes nothing of another.
const EDS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../eds/devices/wdga.eds");

type Write = fn(&mut String, &Record, &str, &lexican_bus::decode::Message<'_>);

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let description = description();
    if let [flag, frames] = arguments.as_slice()
        && flag == "--once"
    {
        let log = made_up(frames.parse().unwrap_or(FRAMES));
        black_box(decode(&log, &description, write_text));
        return;
    }
    let log = made_up(FRAMES);
    let forms: [(&str, Write); 3] = [
        ("read only", |_, _, _, _| ()),
        ("text", write_text),
        ("json", write_json),
    ];
    for (name, write) in forms {
        let runs = (0..5).map(|_| time(&log, &description, write));
        let best = runs.min().unwrap_or_default().as_secs_f64();
        println!(
            "{name:10} {:6.2} million frames/s, {:4.0} MB/s of log",
            1.0 / best * FRAMES as f64 / 1e6,
            log.len() as f64 / best / 1e6
        );
    }
}

fn description() -> Description {
    let Reading { dictionary, .. } = lexican_eds::read(EDS, std::fs::read(EDS).unwrap_or_default());
    Description::new(&dictionary)
}

fn time(log: &str, description: &Description, write: Write) -> Duration {
    let start = Instant::now();
    black_box(decode(log, description, write));
    start.elapsed()
}

/// How many bytes are written.
fn decode(log: &str, description: &Description, write: Write) -> usize {
    let mut reader = Reader::new(log.as_bytes());
    let mut decoder = Decoder::new(Some(description));
    let (mut lines, mut written) = (String::new(), 0);
    while let Ok(Some(record)) = reader.next_record() {
        let message = decoder.decode(&record.frame);
        write(&mut lines, &record, reader.channel_name(record.channel), &message);
        if lines.len() >= 1 << 16 {
            written += lines.len();
            lines.clear();
        }
    }
    written + lines.len()
}

fn made_up(frames: usize) -> String {
    let mut log = String::new();
    for at in 0..frames {
        let (node, value) = (at % 4 + 1, at.wrapping_mul(2_654_435_761) & 0xFFFF_FFFF);
        let _ = write!(log, "({}.{:06}) can0 ", 1_700_000_000 + at / 8000, at % 8000 * 125);
        let _ = match at % 10 {
            0 => writeln!(log, "{:03X}#05", 0x700 + node),
            1 => writeln!(log, "605#4004600000000000"),
            2 => writeln!(log, "585#43046000{value:08X}"),
            _ => writeln!(log, "{:03X}#{value:08X}", 0x180 + node),
        };
    }
    log
}
