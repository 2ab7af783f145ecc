//! `lexican decode`

use std::{
    io::{BufRead as _, BufReader, Write as _},
    process::Stdio,
};

use crate::lexican::Lexican;

const EDS: &[u8] = include_bytes!("../../../eds/devices/wdga.eds");
/// Each service once; the SDO transfers are telegrams of CiA 301's tables, written by hand.
const LOG: &[u8] = include_bytes!("decode.log");

fn lexican() -> Lexican {
    Lexican::with(&[("encoder.eds", EDS), ("bus.log", LOG)])
}

#[test]
fn each_service_is_told_in_the_words_of_the_file() {
    let ran = lexican().run(&["decode", "bus.log", "--eds", "encoder.eds@5"]);
    insta::assert_snapshot!("decoded", ran.printed(0));
}

#[test]
fn without_a_number_a_file_describes_every_node_and_without_a_file_there_are_no_names() {
    let lexican = lexican();
    let numbered = lexican.run(&["decode", "bus.log", "--eds", "encoder.eds@5"]);
    let any = lexican.run(&["decode", "bus.log", "--eds", "encoder.eds"]);
    assert_eq!(any, numbered);
    let nameless = lexican.run(&["decode", "bus.log"]);
    let line = nameless
        .printed(0)
        .lines()
        .find(|line| line.contains("585 43 18 10 01"));
    assert!(
        line.unwrap().ends_with("5 SDO    1018sub1 = 9B 00 00 00"),
        "{nameless:#?}"
    );
}

#[test]
fn the_json_is_an_object_a_line_with_the_same_values() {
    let ran = lexican().run(&["decode", "bus.log", "--eds", "encoder.eds@5", "--format", "json"]);
    let lines: Vec<serde_json::Value> = ran
        .printed(0)
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert_eq!(lines.len(), str::from_utf8(LOG).unwrap().lines().count());
    let vendor = lines.iter().find(|line| line["data"] == "431810019B000000").unwrap();
    assert_eq!((&vendor["object"], &vendor["value"]), (&"1018sub1".into(), &155.into()));
    let remapped = lines.iter().find(|line| line["data"] == "FEFFD2040000").unwrap();
    assert_eq!(remapped["values"][1]["value"], 1234);
    assert_eq!(remapped["time_us"], 1_001_800);
}

#[test]
fn damaged_lines_are_mentioned_with_their_numbers() {
    let log = b"(1.0) can0 000#0100\nnothing\n(1.0) can0 000#01000\n";
    let ran = Lexican::with(&[("bus.log", log)]).run(&["decode", "bus.log"]);
    assert_eq!(ran.code, Some(0));
    assert_eq!(ran.stdout.lines().count(), 1);
    assert_eq!(
        ran.stderr,
        "note: bus.log:2: the identifier is none; 2 of 3 lines could not be read and were passed over: 2, 3\n"
    );
}

#[test]
fn what_is_no_log_and_files_that_contradict_each_other_are_refused() {
    let lexican = lexican();
    assert_eq!(
        lexican.run(&["decode", "encoder.eds"]).failed(),
        "error: encoder.eds: this is no log of candump, no Vector ASC and no CSV of python-can; name a log of one of them\n"
    );
    assert_eq!(
        lexican
            .run(&["decode", "bus.log", "--eds", "encoder.eds", "--eds", "encoder.eds"])
            .failed(),
        "error: two files describe all nodes; say which node each is of: --eds FILE@NODE\n"
    );
    let ran = lexican.run(&["decode", "bus.log", "--eds", "encoder.eds@128"]);
    assert!(ran.stderr.contains("a node-ID is a number from 1 to 127"), "{ran:#?}");
}

#[test]
fn a_frame_is_printed_before_the_next_one_comes() {
    let lexican = lexican();
    let mut command = lexican.command(&["decode", "-"]);
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let (mut stdin, stdout) = (child.stdin.take().unwrap(), child.stdout.take().unwrap());
    let mut lines = BufReader::new(stdout).lines();
    for state in ["00", "7F", "05"] {
        writeln!(stdin, "(1.000000) can0 705#{state}").unwrap();
        let line = lines.next().unwrap().unwrap();
        assert!(line.contains(&format!("705 {state} ")), "{line}");
    }
    drop(stdin);
    assert!(child.wait().unwrap().success());
}
