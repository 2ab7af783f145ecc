//! `lexican check`

use std::{fs, process::Stdio};

use crate::lexican::Lexican;

const GOOD: &[u8] = include_bytes!("../../../tests/fixtures/rules/INI001.fixed.eds");
/// One finding at deny.
const DENIED: &[u8] = include_bytes!("../../../tests/fixtures/rules/OBJ002.eds");
/// One finding at warn.
const WARNED: &[u8] = include_bytes!("../../../tests/fixtures/rules/EDS005.eds");
/// One finding at note.
const NOTED: &[u8] = include_bytes!("../../../tests/fixtures/rules/OBJ013.eds");

#[test]
fn a_good_file_is_clean() {
    let ran = Lexican::with(&[("good.eds", GOOD)]).run(&["check", "good.eds"]);
    assert_eq!(ran.printed(0), "1 file checked: no findings\n");
}

#[test]
fn findings_are_printed_with_place_line_and_cure() {
    let files: &[(&str, &[u8])] = &[("denied.eds", DENIED), ("warned.eds", WARNED), ("noted.eds", NOTED)];
    let ran = Lexican::with(files).run(&["check", "denied.eds", "warned.eds", "noted.eds"]);
    insta::assert_snapshot!("text", ran.printed(1));
}

#[test]
fn only_findings_at_deny_end_with_1() {
    let lexican = Lexican::with(&[("denied.eds", DENIED), ("warned.eds", WARNED)]);
    lexican.run(&["check", "warned.eds"]).printed(0);
    lexican
        .run(&["check", "warned.eds", "--level", "EDS005=deny"])
        .printed(1);
    lexican
        .run(&["check", "denied.eds", "--level", "obj002=Warn"])
        .printed(0);
    lexican.run(&["check", "denied.eds"]).printed(1);
}

#[test]
fn an_allowed_rule_is_silent_and_a_code_beats_its_family() {
    let lexican = Lexican::with(&[("denied.eds", DENIED)]);
    let allowed = lexican.run(&["check", "denied.eds", "--level", "OBJ=allow"]);
    assert_eq!(allowed.printed(0), "1 file checked: no findings\n");
    let noted = lexican.run(&["check", "denied.eds", "--level", "OBJ002=note", "--level", "OBJ=allow"]);
    assert!(noted.printed(0).contains("note[OBJ002]"), "{}", noted.stdout);
}

#[test]
fn the_json_is_what_its_description_shows() {
    let page = include_str!("../../../docs/json.md");
    let block = |start: &str| {
        let (_, rest) = page.split_once(start).unwrap();
        rest.split_once("```").unwrap().0
    };
    let lexican = Lexican::with(&[("pump.eds", block("```ini\n").as_bytes())]);
    let command = "check pump.eds --level EDS001=allow --level EDS006=allow --level COM001=allow --format json";
    assert!(page.contains(&format!("`lexican {command}`")));
    let ran = lexican.run(&command.split(' ').collect::<Vec<_>>());
    assert_eq!(ran.printed(1), block("```json\n"));
}

#[test]
fn a_dash_is_standard_input() {
    let lexican = Lexican::with(&[]);
    let ran = lexican.run_with_input(&["check", "-"], DENIED);
    assert!(ran.printed(1).starts_with("<stdin>:93:10: error[OBJ002]"), "{ran:#?}");
}

#[test]
fn a_directory_stands_for_the_descriptions_in_it_and_below() {
    let lexican = Lexican::with(&[
        ("devices/b.eds", WARNED),
        ("devices/a.EDS", WARNED),
        ("devices/old/c.dcf", WARNED),
        ("devices/readme.txt", b"not this one"),
        ("elsewhere.eds", DENIED),
    ]);
    let ran = lexican.run(&["check", "devices"]);
    let heads = ran.printed(0).lines().filter(|line| line.contains("warning[EDS005]"));
    let files: Vec<&str> = heads.map(|line| line.split(':').next().unwrap()).collect();
    let separated = ["devices/a.EDS", "devices/b.eds", "devices/old/c.dcf"]
        .map(|path| path.replace('/', std::path::MAIN_SEPARATOR_STR));
    assert_eq!(files, separated);
}

#[test]
fn a_directory_without_descriptions_is_refused() {
    let ran = Lexican::with(&[("empty/readme.txt", b"")]).run(&["check", "empty"]);
    assert_eq!(
        ran.failed(),
        "error: no .eds or .dcf file in empty; name the file itself\n"
    );
}

#[test]
fn a_missing_file_is_named_and_the_others_are_checked() {
    let lexican = Lexican::with(&[("denied.eds", DENIED)]);
    let ran = lexican.run(&["check", "missing.eds", "denied.eds"]);
    assert_eq!(
        ran.failed(),
        "error: cannot read missing.eds: there is no such file or directory\n"
    );
    assert!(ran.stdout.contains("error[OBJ002]"), "{}", ran.stdout);
    assert!(ran.stdout.ends_with("1 file checked: 1 error\n"), "{}", ran.stdout);
}

#[test]
fn a_failure_is_in_the_json_as_well() {
    let ran = Lexican::with(&[]).run(&["check", "missing.eds", "--format", "json"]);
    ran.failed();
    let root: serde_json::Value = serde_json::from_str(&ran.stdout).unwrap();
    assert_eq!(
        root["failures"][0],
        "cannot read missing.eds: there is no such file or directory"
    );
    assert_eq!(root["summary"]["files"], 0);
}

#[test]
fn what_is_no_description_is_one_finding() {
    let files: &[(&str, &[u8])] = &[
        ("empty.eds", b""),
        ("binary.eds", &[0x7F, b'E', b'L', b'F', 0, 1, 2, 3, 0, 0, 0xFF, 0xFE]),
        (
            "pump.xdd",
            b"<?xml version=\"1.0\"?>\n<ISO15745ProfileContainer xmlns=\"http://www.canopen.org/xml/1.0\"/>\n",
        ),
        ("odva.eds", b"[File]\nDescText = \"x\";\n[Device]\nVendCode = 1;\n"),
    ];
    let lexican = Lexican::with(files);
    for (name, _) in files {
        let ran = lexican.run(&["check", name]);
        let text = ran.printed(1);
        assert!(text.ends_with("1 file checked: 1 error\n"), "{text}");
        assert!(
            text.contains("error[INI014]: this is no EDS or DCF of CANopen"),
            "{text}"
        );
    }
}

#[test]
fn unknown_codes_and_levels_are_refused() {
    let lexican = Lexican::with(&[("good.eds", GOOD)]);
    let refused = |level: &str| {
        lexican
            .run(&["check", "good.eds", "--level", level])
            .failed()
            .to_owned()
    };
    assert_eq!(
        refused("EDS05=warn"),
        "error: --level EDS05=warn: unknown rule `EDS05`; did you mean EDS005?\n"
    );
    assert_eq!(
        refused("EDS005=fatal"),
        "error: --level EDS005=fatal: unknown level `fatal`; use allow, note, warn or deny\n"
    );
    assert_eq!(
        refused("EDS005"),
        "error: --level EDS005: write CODE=LEVEL, such as EDS004=warn or INI=allow\n"
    );
}

#[test]
fn colour_comes_on_demand_alone() {
    let lexican = Lexican::with(&[("denied.eds", DENIED)]);
    let is_coloured = |arguments: &[&str], variable: Option<&str>| {
        let mut command = lexican.command(&[&["check", "denied.eds"], arguments].concat());
        let output = command.envs(variable.map(|name| (name, "1"))).output().unwrap();
        output.stdout.contains(&0x1B)
    };
    assert!(!is_coloured(&[], None), "a pipe is no terminal");
    assert!(is_coloured(&["--color", "always"], None));
    assert!(is_coloured(&[], Some("CLICOLOR_FORCE")));
    assert!(!is_coloured(&["--color", "never"], Some("CLICOLOR_FORCE")));
    assert!(!is_coloured(&[], Some("NO_COLOR")));
    assert!(!is_coloured(&["--format", "json", "--color", "always"], None));
}

#[test]
fn the_colours_are_those_of_rustc() {
    let lexican = Lexican::with(&[("denied.eds", DENIED)]);
    let ran = lexican.run(&["check", "denied.eds", "--color", "always"]);
    insta::assert_snapshot!("coloured", ran.printed(1).replace('\u{1b}', "␛"));
}

#[test]
fn nothing_that_steers_a_terminal_gets_out() {
    let name = "\u{1b}]0;pwned\u{7}.eds";
    let text = b"[FileInfo]\nFile\x1b[2JVersion=\x1b[31m1\n\x1b[2Jjunk\n\x9b31mjunk\n";
    let lexican = Lexican::with(&[(name, text)]);
    for ran in [
        lexican.run(&["check", name]),
        lexican.run(&["check", name, "--color", "never"]),
        lexican.run(&["check", "\u{1b}[2Jmissing"]),
    ] {
        for text in [&ran.stdout, &ran.stderr] {
            let steering = text.chars().find(|c| c.is_control() && *c != '\n');
            assert_eq!(steering, None, "{text:?}");
        }
    }
}

#[test]
fn a_reader_that_leaves_is_no_error() {
    let junk = "junk\n".repeat(20_000);
    let lexican = Lexican::with(&[("junk.eds", [GOOD, junk.as_bytes()].concat().as_slice())]);
    let mut command = lexican.command(&["check", "junk.eds"]);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    assert_eq!(output.status.code(), Some(0), "junk lines are warnings");
}

#[test]
fn a_file_is_left_as_it_was() {
    let lexican = Lexican::with(&[("denied.eds", DENIED)]);
    lexican.run(&["check", "denied.eds"]).printed(1);
    assert_eq!(fs::read(lexican.path().join("denied.eds")).unwrap(), DENIED);
    assert_eq!(fs::read_dir(lexican.path()).unwrap().count(), 1);
}

#[test]
fn the_encoders_of_this_project_are_clean() {
    let devices = concat!(env!("CARGO_MANIFEST_DIR"), "/../eds/devices");
    // The WDGA's manual gives 6200h and 1800h:05 different defaults.
    let ran = Lexican::with(&[]).run(&["check", devices, "--level", "ENC019=allow"]);
    assert!(
        ran.printed(0).ends_with("files checked: no findings\n"),
        "{}",
        ran.stdout
    );
}

#[test]
fn many_files_are_reported_in_the_order_of_their_names() {
    let names: Vec<String> = (100..300).map(|number| format!("devices/{number}.eds")).collect();
    let files: Vec<(&str, &[u8])> = names.iter().map(|name| (name.as_str(), DENIED)).collect();
    let lexican = Lexican::with(&files);
    let ran = lexican.run(&["check", "devices"]);
    let heads = ran
        .printed(1)
        .lines()
        .filter_map(|line| line.split_once(":93:10: error"));
    let seen: Vec<String> = heads
        .map(|(name, _)| name.replace(std::path::MAIN_SEPARATOR, "/"))
        .collect();
    assert_eq!(seen, names);
    assert!(ran.stdout.ends_with("200 files checked: 200 errors\n"));
    assert_eq!(lexican.run(&["check", "devices"]), ran, "each run prints the same");
}

#[test]
fn what_is_below_the_level_that_is_shown_is_counted_and_counts_for_the_exit_code_as_before() {
    let lexican = Lexican::with(&[("denied.eds", DENIED), ("warned.eds", WARNED), ("noted.eds", NOTED)]);
    let run = |level: &str, code| {
        let files = ["check", "denied.eds", "warned.eds", "noted.eds", "--min-level", level];
        let ran = lexican.run(&files);
        let text = ran.printed(code).to_owned();
        let heads = text.lines().filter(|line| line.contains(".eds:")).count();
        (
            heads,
            text.lines().find(|line| line.contains("checked: ")).unwrap().to_owned(),
        )
    };
    assert_eq!(
        run("note", 1),
        (3, "3 files checked: 1 error, 1 warning, 1 note".into())
    );
    let hidden = "3 files checked: 1 error, 1 warning (1 below --min-level not shown)";
    assert_eq!(run("warn", 1), (2, hidden.into()));
    let hidden = "3 files checked: 1 error (2 below --min-level not shown)";
    assert_eq!(run("deny", 1), (1, hidden.into()));
}

#[test]
fn a_quiet_run_says_what_is_wrong_and_nothing_else() {
    let lexican = Lexican::with(&[("good.eds", GOOD), ("denied.eds", DENIED)]);
    assert_eq!(lexican.run(&["check", "-q", "good.eds"]).printed(0), "");
    let ran = lexican.run(&["check", "--quiet", "good.eds", "denied.eds"]);
    assert!(ran.printed(1).starts_with("denied.eds:93:10: error"));
    assert!(!ran.stdout.contains("checked"), "{}", ran.stdout);
}
