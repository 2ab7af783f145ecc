//! `lexican validate`

use crate::lexican::{Lexican, Ran};

const EDS: &[u8] = include_bytes!("../../../tests/fixtures/rules/DMP007.eds");
/// Two findings at deny.
const DENIED: &[u8] = include_bytes!("../../../tests/fixtures/rules/DMP007.json");
const GOOD: &[u8] = include_bytes!("../../../tests/fixtures/rules/DMP007.fixed.json");
/// A file and a dump with one finding at warn.
const WARNED_EDS: &[u8] = include_bytes!("../../../tests/fixtures/rules/DMP017.eds");
const WARNED: &[u8] = include_bytes!("../../../tests/fixtures/rules/DMP017.json");
/// A file with an error of its own.
const BAD_EDS: &[u8] = include_bytes!("../../../tests/fixtures/rules/OBJ002.eds");

fn lexican() -> Lexican {
    Lexican::with(&[("pump.eds", EDS), ("denied.json", DENIED), ("good.json", GOOD)])
}

/// What `lexican validate` says of a file and a dump with these contents.
fn validate(eds: &[u8], dump: &[u8]) -> Ran {
    Lexican::with(&[("pump.eds", eds), ("node5.json", dump)]).run(&["validate", "pump.eds", "node5.json"])
}

#[test]
fn a_device_that_is_the_one_of_its_file_is_clean() {
    let ran = lexican().run(&["validate", "pump.eds", "good.json"]);
    assert_eq!(ran.printed(0), "1 device checked: no findings\n");
}

#[test]
fn differences_are_printed_at_their_place_in_the_file() {
    let ran = lexican().run(&["validate", "pump.eds", "denied.json"]);
    insta::assert_snapshot!("text", ran.printed(1));
}

#[test]
fn the_json_has_the_form_of_check() {
    let ran = lexican().run(&["validate", "pump.eds", "denied.json", "--format", "json"]);
    let root: serde_json::Value = serde_json::from_str(ran.printed(1)).unwrap();
    assert_eq!(root["format"], "lexican-check");
    assert_eq!(root["files"][0]["path"], "pump.eds");
    let finding = &root["files"][0]["findings"][1];
    assert_eq!(finding["code"], "DMP007");
    assert_eq!(finding["section"], "[1018sub2]");
    assert_eq!(
        finding["message"],
        "1018sub2 answers 0x00000002; the file says 0x00000001"
    );
    assert_eq!(finding["place"]["line"], 94);
    assert_eq!(root["summary"]["deny"], 2);
}

#[test]
fn only_differences_at_deny_end_with_1_and_levels_can_be_changed() {
    let warned = Lexican::with(&[("pump.eds", WARNED_EDS), ("node5.json", WARNED)]);
    warned.run(&["validate", "pump.eds", "node5.json"]).printed(0);
    warned
        .run(&["validate", "pump.eds", "node5.json", "--level", "DMP017=deny"])
        .printed(1);
    let allowed = lexican().run(&["validate", "pump.eds", "denied.json", "--level", "DMP=allow"]);
    assert_eq!(allowed.printed(0), "1 device checked: no findings\n");
}

#[test]
fn either_may_come_from_standard_input() {
    let ran = lexican().run_with_input(&["validate", "pump.eds", "-"], GOOD);
    ran.printed(0);
    let ran = lexican().run_with_input(&["validate", "-", "denied.json"], EDS);
    assert!(ran.printed(1).starts_with("<stdin>:58:14: error[DMP007]"), "{ran:#?}");
    let ran = lexican().run_with_input(&["validate", "-", "-"], EDS);
    assert_eq!(
        ran.failed(),
        "error: - cannot be both; name the EDS file, then the dump\n"
    );
}

#[test]
fn a_file_that_is_wrong_itself_is_mentioned() {
    let ran = validate(BAD_EDS, GOOD);
    assert_eq!(
        ran.stderr,
        "note: pump.eds itself has 1 error; `lexican check pump.eds` shows them\n"
    );
}

#[test]
fn a_missing_file_or_a_directory_is_named() {
    let lexican = lexican();
    for arguments in [["validate", "no.eds", "good.json"], ["validate", "pump.eds", "no.json"]] {
        let ran = lexican.run(&arguments);
        let missing = arguments.iter().find(|argument| argument.starts_with("no")).unwrap();
        assert_eq!(
            ran.failed(),
            format!("error: cannot read {missing}: there is no such file or directory\n")
        );
    }
    assert_eq!(
        lexican.run(&["validate", "pump.eds", "."]).failed(),
        "error: cannot read .: it is a directory; name a file\n"
    );
}

#[test]
fn swapped_arguments_are_recognised() {
    let ran = lexican().run(&["validate", "good.json", "pump.eds"]);
    assert_eq!(
        ran.failed(),
        "error: good.json is JSON, not an EDS; the EDS file comes first, then the dump\n"
    );
    let ran = Lexican::with(&[("a.eds", EDS), ("b.eds", EDS)]).run(&["validate", "a.eds", "b.eds"]);
    assert_eq!(
        ran.failed(),
        "error: b.eds:1:1: this looks like an EDS file, not a dump; the EDS file comes first, then the dump\n"
    );
}

#[test]
fn a_dump_that_is_none_is_refused_with_its_place_and_the_cure() {
    let good = str::from_utf8(GOOD).unwrap();
    let refused = |dump: &str| validate(EDS, dump.as_bytes()).failed().to_owned();
    assert_eq!(
        refused(""),
        "error: node5.json:1:1: the dump is empty; take the dump again\n"
    );
    assert_eq!(
        refused("\u{7F}ELF"),
        "error: node5.json:1:1: this is not a dump: it does not begin with `{`; name a dump, as docs/dump-format.md describes it\n"
    );
    assert_eq!(
        refused(&good[..good.len() / 2]),
        "error: node5.json:8:12: the dump ends in the middle: EOF while parsing a string; the file is cut off; take the dump again\n"
    );
    assert_eq!(
        refused(&good.replace("\"version\": 1", "\"version\": 2")),
        "error: node5.json:3:3: the dump is of version 2; this program reads up to version 1; use a newer release of Lexican\n"
    );
    assert_eq!(
        refused(&good.replace("\"04\"", "\"4\"")),
        "error: node5.json:8:19: `4` is not bytes as 92 01 02 00; docs/dump-format.md describes what a dump holds\n"
    );
    assert_eq!(
        refused("{ \"jsonrpc\": 2 }"),
        "error: node5.json:1:1: this JSON is not a dump: it has no \"format\": \"lexican-dump\"; name a dump, as docs/dump-format.md describes it\n"
    );
}

#[test]
fn a_file_that_describes_nothing_is_refused() {
    for eds in [
        &b""[..],
        b"\x7FELF\0\0",
        b"<?xml version=\"1.0\"?>\n<x/>\n",
        b"[File]\nDescText=\"x\";\n",
    ] {
        let ran = validate(eds, GOOD);
        assert_eq!(
            ran.failed(),
            "error: pump.eds describes no object; `lexican check pump.eds` says what it is\n"
        );
    }
}

#[test]
fn nothing_in_a_dump_steers_the_terminal() {
    let good = str::from_utf8(GOOD).unwrap();
    let steering = good.replace("\"node\"", "\"\\u001b[2J\": 1, \"node\"");
    let ran = validate(EDS, steering.as_bytes());
    assert!(!ran.failed().contains('\u{1b}'), "{ran:#?}");
}

/// Node 5 is read in full but for 1018sub2, which differs from the file, in segments and in one frame.
fn log() -> String {
    let dump: serde_json::Value = serde_json::from_slice(DENIED).unwrap();
    let objects = dump["objects"].as_object().unwrap().iter();
    let transfers = objects.flat_map(|(address, value)| upload(address, &value.as_str().unwrap().replace(' ', "")));
    let frames = ["705#00".to_owned(), "085#3081110000000000".to_owned()];
    let lines = frames.into_iter().chain(transfers);
    let lines: Vec<String> = lines.map(|frame| format!("(2.000000) can0 {frame}")).collect();
    lines.join("\n") + "\n"
}

/// The frames in which `address` is read, expedited or in segments.
fn upload(address: &str, value: &str) -> Vec<String> {
    let (index, sub) = address.split_once("sub").unwrap();
    let address = format!("{}{}{sub:0>2}", &index[2..], &index[..2]);
    let mut frames = vec![format!("605#40{address}00000000")];
    if value.len() <= 8 {
        let command = 0x43 + (4 - value.len() / 2) * 4;
        frames.push(format!("585#{command:02X}{address}{value:0<8}"));
        return frames;
    }
    frames.push(format!("585#40{address}00000000"));
    let parts: Vec<&[u8]> = value.as_bytes().chunks(14).collect();
    for (number, part) in parts.iter().enumerate() {
        let (toggle, last) = (number % 2 * 16, usize::from(number + 1 == parts.len()));
        let (command, part) = (toggle + (7 - part.len() / 2) * 2 + last, str::from_utf8(part).unwrap());
        frames.push(format!("605#{:02X}00000000000000", 0x60 + toggle));
        frames.push(format!("585#{command:02X}{part:0<14}"));
    }
    frames
}

#[test]
fn a_log_in_which_the_device_is_read_is_as_good_as_a_dump() {
    let dumped = lexican().run(&["validate", "pump.eds", "denied.json"]);
    let lexican = Lexican::with(&[("pump.eds", EDS), ("bus.log", log().as_bytes())]);
    for arguments in [
        &["validate", "pump.eds", "bus.log"][..],
        &["validate", "pump.eds", "bus.log", "--node", "5"],
    ] {
        let logged = lexican.run(arguments);
        assert_eq!((logged.code, &logged.stdout), (Some(1), &dumped.stdout), "{logged:#?}");
        assert!(
            logged.stderr.contains("1 boot-ups, 0 heartbeats, 1 emergencies\n"),
            "{logged:#?}"
        );
        assert!(
            logged.stderr.contains("8130h life guarding or heartbeat"),
            "{logged:#?}"
        );
    }
    let piped = lexican.run_with_input(&["validate", "pump.eds", "-"], log().as_bytes());
    assert_eq!((piped.code, piped.stdout), (Some(1), dumped.stdout));
}

#[test]
fn of_a_part_of_a_log_what_nobody_asked_for_is_no_finding_unless_it_is_wanted() {
    let log = log();
    let part: Vec<&str> = log.lines().filter(|line| line.contains("181002")).collect();
    let part = part.join("\n");
    let lexican = Lexican::with(&[("pump.eds", EDS), ("bus.log", part.as_bytes())]);
    let ran = lexican.run(&["validate", "pump.eds", "bus.log"]);
    assert_eq!(ran.stdout.matches("error[").count(), 1, "{ran:#?}");
    assert!(ran.stdout.contains("error[DMP007]"), "{ran:#?}");
    let strict = lexican.run(&["validate", "pump.eds", "bus.log", "--level", "DMP012=deny"]);
    assert!(strict.stdout.contains("error[DMP012]"), "{strict:#?}");
}

#[test]
fn a_log_of_several_nodes_needs_a_number_and_one_of_none_is_refused() {
    let two = log() + &log().replace("605#", "606#").replace("585#", "586#");
    let lexican = Lexican::with(&[
        ("pump.eds", EDS),
        ("two.log", two.as_bytes()),
        ("none.log", b"(1.0) can0 705#05\n"),
    ]);
    assert_eq!(
        lexican.run(&["validate", "pump.eds", "two.log"]).failed(),
        "error: in two.log the nodes 5, 6 are read; say which one is meant: --node N\n"
    );
    assert_eq!(
        lexican.run(&["validate", "pump.eds", "two.log", "--node", "5"]).code,
        Some(1)
    );
    assert_eq!(
        lexican.run(&["validate", "pump.eds", "none.log"]).failed(),
        "error: in none.log nobody reads an object of any node\n"
    );
    assert_eq!(
        lexican
            .run(&["validate", "pump.eds", "two.log", "--node", "7"])
            .failed(),
        "error: in two.log nobody reads an object of node 7\n"
    );
}
