//! What reading costs, stage by stage: `cargo bench -p lexican-eds --bench reading`.
//!
//! Time is the best of several runs. Instructions are counted by callgrind where valgrind is installed, as the difference
//! of two runs of this program, one of which stops a stage earlier; rust-ini's share is what callgrind sees inside its
//! parser. A name behind `--` reads only the files that have it in theirs.
#![expect(clippy::print_stdout, reason = "a bench prints its figures")]

use std::fmt::Write as _;
use std::hint::black_box;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use lexican_eds::{document::Document, ir::Dictionary, model::Eds, source::Source};

const STAGES: [&str; 5] = ["nothing", "decode", "read", "interpret", "lower"];

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [flag, file, stage] = arguments.as_slice()
        && flag == "--once"
    {
        let bytes = bytes_of(file);
        let _ = black_box(run(bytes, stage));
        return;
    }
    let wanted = arguments.iter().find(|argument| !argument.starts_with("--"));
    println!(
        "{:14} {:>8}  {:>9} {:>9} {:>9} {:>9} {:>9}",
        "", "kB", "decode", "read", "interpret", "lower", "all"
    );
    for file in files() {
        if wanted.is_none_or(|wanted| file.contains(wanted.as_str())) {
            print_time(&file);
            print_instructions(&file);
        }
    }
}

/// The made-up files, and the ones beside the repository.
fn files() -> Vec<String> {
    let beside = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/bench");
    let real = ["bench_100.eds", "bench_1000.eds"].map(|name| beside.join(name));
    let real = real
        .iter()
        .filter(|path| path.exists())
        .map(|path| path.display().to_string());
    real.chain(["1000", "10000", "20000", "40000"].map(str::to_owned))
        .collect()
}

/// A file, or a made-up one with so many objects.
fn bytes_of(file: &str) -> Vec<u8> {
    match file.parse() {
        Ok(objects) => made_up(objects).into_bytes(),
        Err(_) => std::fs::read(file).unwrap_or_default(),
    }
}

/// Objects of which each has a name and a default of its own; half of the lines differ from all others.
fn made_up(objects: u32) -> String {
    let mut text = String::from("[FileInfo]\nFileName=bench.eds\n\n");
    let list = [
        ("MandatoryObjects", 0),
        ("OptionalObjects", 0),
        ("ManufacturerObjects", objects),
    ];
    for (name, count) in list {
        let _ = writeln!(text, "[{name}]\nSupportedObjects={count}");
        for number in 1..=count {
            let _ = writeln!(text, "{number}=0x{:04X}", 0x1FFF + number);
        }
    }
    for number in 0..objects {
        let _ = writeln!(
            text,
            "\n[{:04X}]\nParameterName=Object {number}\nObjectType=0x7\nDataType=0x0007\nAccessType=rw\n\
             DefaultValue=0x{number:08X}\nPDOMapping=0",
            0x2000 + number
        );
    }
    text
}

/// The time when each stage up to `last` was done, since the start.
fn run(bytes: Vec<u8>, last: &str) -> Vec<Duration> {
    let start = Instant::now();
    let mut done = vec![start.elapsed()];
    let reached = |done: &mut Vec<Duration>, stage| {
        done.push(start.elapsed());
        stage == last
    };
    if last == STAGES[0] {
        return done;
    }
    let source = black_box(Source::decode("bench.eds", bytes));
    if reached(&mut done, STAGES[1]) {
        return done;
    }
    let document = black_box(Document::read(source));
    if reached(&mut done, STAGES[2]) {
        return done;
    }
    let eds = black_box(Eds::interpret(&document));
    if reached(&mut done, STAGES[3]) {
        return done;
    }
    let _dictionary = black_box(Dictionary::lower(&eds));
    reached(&mut done, STAGES[4]);
    done
}

fn print_time(file: &str) {
    let bytes = bytes_of(file);
    let start = Instant::now();
    let enough = |runs: usize| runs >= 10 && start.elapsed() > Duration::from_secs(2);
    let runs = (0..200)
        .take_while(|runs| !enough(*runs))
        .map(|_| run(bytes.clone(), "lower"));
    let Some(best) = runs.min_by_key(|done| done.last().copied()) else {
        return;
    };
    let mut line = format!("{:14} {:>8}", name(file), bytes.len() / 1000);
    let stages = best.windows(2).map(|pair| pair[1].saturating_sub(pair[0]));
    for time in stages.chain(best.last().copied()) {
        let _ = write!(line, "  {:>6.2} ms", time.as_secs_f64() * 1e3);
    }
    println!("{line}");
}

fn print_instructions(file: &str) {
    let counts: Vec<_> = STAGES
        .iter()
        .filter_map(|stage| instructions(file, stage, None))
        .collect();
    let ([first, .., last], Some(rust_ini)) = (
        counts.as_slice(),
        instructions(file, "read", Some("ini::Parser::parse")),
    ) else {
        return;
    };
    let mut line = format!("{:14} {:>8}", "", "");
    for count in counts.windows(2).map(|pair| pair[1] - pair[0]).chain([last - first]) {
        let _ = write!(line, "  {:>6.2} M ", millions(count));
    }
    println!("{line}   of read, rust-ini: {:.2} M", millions(rust_ini));
}

/// The instructions of this program when it reads `file` up to `stage`; those within a function only, if one is given.
fn instructions(file: &str, stage: &str, function: Option<&str>) -> Option<i64> {
    let program = std::env::current_exe().ok()?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .args(function.map(|function| format!("--toggle-collect={function}")))
        .arg(program)
        .args(["--once", file, stage])
        .output()
        .ok()?;
    let report = String::from_utf8(output.stderr).ok()?;
    let count = report.lines().find_map(|line| line.split_once("Collected : "))?.1;
    count.split_whitespace().next()?.parse().ok()
}

#[expect(clippy::cast_precision_loss, reason = "for people to read")]
fn millions(count: i64) -> f64 {
    count as f64 / 1e6
}

fn name(file: &str) -> &str {
    Path::new(file)
        .file_name()
        .and_then(|name| name.to_str())
        .unwrap_or(file)
}
