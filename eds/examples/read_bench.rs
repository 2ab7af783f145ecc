//! How long reading takes, end to end and stage by stage.
//!
//! `cargo run --release -p lexican-eds --example read_bench -- [ROUNDS] (FILE | OBJECTS)…`
//!
//! For each file, or for a generated one with that many objects, the shortest of ROUNDS (default 21) in milliseconds. With
//! ROUNDS 1 and 2 under callgrind the difference is the instructions of one reading:
//! `valgrind --tool=callgrind target/release/examples/read_bench 1 10000`.
//! `--write OBJECTS` prints the generated file instead.
#![expect(clippy::print_stdout, reason = "an example that prints")]

use std::env;
use std::fmt::Write as _;
use std::fs;
use std::hint::black_box;
use std::time::{Duration, Instant};

use lexican_eds::document::Document;
use lexican_eds::ir::Dictionary;
use lexican_eds::model::Eds;
use lexican_eds::source::Source;

fn main() {
    let mut arguments = env::args().skip(1).peekable();
    if arguments.next_if(|argument| argument == "--write").is_some() {
        return arguments.for_each(|objects| print!("{}", generate(objects.parse().unwrap_or(0))));
    }
    let rounds = arguments.next_if(|argument| argument.parse::<u8>().is_ok());
    let rounds = rounds.and_then(|rounds| rounds.parse().ok()).unwrap_or(21);
    println!("|  | KiB | decode | document | model | dictionary | all, ms | objects | values |");
    println!("|---|--:|--:|--:|--:|--:|--:|--:|--:|");
    for argument in arguments {
        match bytes(&argument) {
            Ok(bytes) => measure(&argument, &bytes, rounds),
            Err(error) => println!("| {argument} | {error} |"),
        }
    }
}

fn bytes(argument: &str) -> std::io::Result<Vec<u8>> {
    match argument.parse() {
        Ok(objects) => Ok(generate(objects).into_bytes()),
        Err(_) => fs::read(argument),
    }
}

fn measure(name: &str, bytes: &[u8], rounds: u32) {
    let mut best = [Duration::MAX; 5];
    let mut size = (0, 0);
    for _ in 0..rounds {
        let copy = bytes.to_vec();
        let started = Instant::now();
        let source = Source::decode(name, copy);
        let decoded = started.elapsed();
        let document = Document::read(source);
        let read = started.elapsed();
        let eds = Eds::interpret(&document);
        let interpreted = started.elapsed();
        let (dictionary, problems) = Dictionary::lower(&eds);
        let lowered = started.elapsed();
        size = (dictionary.objects.len(), dictionary.entries().count());
        black_box((document, eds, problems, dictionary));
        let stages = [
            decoded,
            read.saturating_sub(decoded),
            interpreted.saturating_sub(read),
            lowered.saturating_sub(interpreted),
            lowered,
        ];
        best = std::array::from_fn(|stage| best[stage].min(stages[stage]));
    }
    let name = name.rsplit('/').next().unwrap_or(name);
    let [decode, document, model, dictionary, all] = best.map(|stage| stage.as_secs_f64() * 1e3);
    println!(
        "| {name} | {} | {decode:.2} | {document:.2} | {model:.2} | {dictionary:.2} | {all:.2} | {} | {} |",
        bytes.len() / 1024,
        size.0,
        size.1,
    );
}

/// An EDS with `objects` single values, as `bench_1000.eds` has them, beside a few arrays.
///
/// There are no more than 65,536 indices: beyond 60,000 objects the file has 250 sub-objects in each of its objects, and
/// `objects` values in all.
fn generate(objects: u32) -> String {
    let mut text = "[FileInfo]\nFileName=generated.eds\nEDSVersion=4.0\n[DeviceInfo]\nVendorName=Nobody\n".to_owned();
    if objects > 60_000 {
        list(&mut text, objects / 250);
        (0..objects / 250).for_each(|number| array(&mut text, FIRST + number, 250));
        return text;
    }
    list(&mut text, objects);
    for number in 0..objects {
        if number % 50 == 0 {
            array(&mut text, FIRST + number, 3);
        } else {
            single(&mut text, FIRST + number);
        }
    }
    text
}

const FIRST: u32 = 0x1000;

fn list(text: &mut String, indices: u32) {
    let _ = write!(text, "[ManufacturerObjects]\nSupportedObjects={indices}\n");
    for number in 0..indices {
        let _ = writeln!(text, "{}=0x{:04X}", number + 1, FIRST + number);
    }
}

fn single(text: &mut String, index: u32) {
    let _ = write!(
        text,
        "\n[{index:04X}]\nParameterName=Value {index:04X}h\nObjectType=0x7\nDataType=0x0007\nAccessType=rw\n\
         DefaultValue=0x00000064\nPDOMapping=1\n"
    );
}

fn array(text: &mut String, index: u32, elements: u8) {
    let _ = write!(
        text,
        "\n[{index:04X}]\nParameterName=Values {index:04X}h\nObjectType=0x8\nSubNumber={}\n",
        elements + 1
    );
    let _ = write!(
        text,
        "\n[{index:04X}sub0]\nParameterName=Number of values\nDataType=0x0005\nAccessType=const\nDefaultValue={elements}\n"
    );
    for sub in 1..=elements {
        let _ = write!(
            text,
            "\n[{index:04X}sub{sub:X}]\nParameterName=Value {sub}\nObjectType=0x7\nDataType=0x0003\nAccessType=ro\n\
             DefaultValue=-{sub}\nPDOMapping=0\n"
        );
    }
}
