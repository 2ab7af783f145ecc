//! Comments that allow a finding where it stands.

use std::{fs, path::Path};

use lexican_eds::rules::{self, Levels};

/// What is found when comments are put above lines of a file with three junk lines, by code and line without comments.
fn found(comments: &[(u32, &str)]) -> Vec<String> {
    found_at(comments, &Levels::default())
}

fn found_at(comments: &[(u32, &str)], levels: &Levels) -> Vec<String> {
    let file = file();
    let lines = (1..).zip(file.lines()).flat_map(|(number, line)| {
        let above = comments.iter().filter(move |(below, _)| *below == number);
        above.map(|(_, comment)| *comment).chain([line])
    });
    let text = lines.collect::<Vec<_>>().join("\n") + "\n";
    let reading = lexican_eds::read("x.eds", text.into_bytes());
    let found = rules::check(&reading, levels);
    let source = reading.document.source();
    let junk = found.iter().map(|finding| {
        let line = source.line_text(source.line_column(finding.span).line);
        format!("{} {line}", finding.code)
    });
    junk.filter(|text| text.starts_with("INI") || text.starts_with("LEX"))
        .collect()
}

/// A good file whose last sections are two objects with junk: lines 1 to 6 from the end.
fn file() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/rules/INI001.fixed.eds");
    let good = fs::read_to_string(path).expect("the fixture is there");
    let (before, heartbeat) = good.split_once("[1017]\n").expect("the fixture has the object");
    format!("{before}[1017]\njunk one\njunk two\n{heartbeat}\n[1016]\njunk three\n")
}

fn line(text: &str) -> u32 {
    let position = file().lines().position(|line| line == text);
    u32::try_from(position.expect("the line is there")).expect("the file is short") + 1
}

const ALL: [&str; 3] = ["INI001 junk one", "INI001 junk two", "INI001 junk three"];

#[test]
fn above_a_line_it_is_about_that_line() {
    assert_eq!(found(&[]), ALL);
    assert_eq!(found(&[(line("junk one"), "; lexican: allow(INI001)")]), ALL[1..]);
    assert_eq!(
        found(&[(line("junk two"), ";lexican:allow(ini) as it was")]),
        [ALL[0], ALL[2]]
    );
}

#[test]
fn above_a_header_it_is_about_the_section() {
    assert_eq!(found(&[(line("[1017]"), "; lexican: allow(INI001)")]), ALL[2..]);
    assert_eq!(found(&[(line("[1016]"), "; lexican: allow(INI001)")]), ALL[..2]);
}

#[test]
fn other_comments_and_empty_lines_may_stand_between() {
    let comment = "; lexican: allow(INI001)\n\n; the tool of old\n";
    assert_eq!(found(&[(line("junk three"), comment)]), ALL[..2]);
    assert_eq!(found(&[(line("[1017]"), comment)]), ALL[2..]);
}

#[test]
fn for_the_file_it_stands_anywhere() {
    assert_eq!(found(&[(1, "; lexican: allow-file(INI001)")]), [""; 0]);
    assert_eq!(found(&[(line("junk three"), "; lexican: allow-file(INI)")]), [""; 0]);
}

#[test]
fn a_finding_about_the_file_as_a_whole_is_allowed_for_the_file() {
    let codes = |text: &str| {
        let found = rules::check(&lexican_eds::read("x.eds", text.into()), &Levels::default());
        found.iter().map(|finding| finding.code.as_str()).collect::<Vec<_>>()
    };
    let bare = "[1001]\nParameterName=Error register\nObjectType=7\nDataType=5\nAccessType=ro\n";
    assert!(codes(bare).contains(&"EDS001"), "{:?}", codes(bare));
    let allowed = format!("; lexican: allow-file(EDS001)\n{bare}");
    assert!(!codes(&allowed).contains(&"EDS001"), "{:?}", codes(&allowed));
}

#[test]
fn what_allows_nothing_is_found_wherever_it_stands() {
    let idle = |comments: &[(u32, &str)]| {
        let found = found(comments).into_iter();
        found.filter(|text| text.starts_with("LEX002")).collect::<Vec<_>>()
    };
    let of_another = "; lexican: allow(OBJ003)";
    assert_eq!(
        idle(&[(line("junk one"), of_another)]),
        [format!("LEX002 {of_another}")]
    );
    let file = "; lexican: allow-file(INI002)";
    assert_eq!(idle(&[(1, file)]), [format!("LEX002 {file}")]);
    // Of two that say the same the second is idle, and so is a wider one when the nearer ones allow everything.
    let twice = "; lexican: allow(INI001)\n; lexican: allow(INI001)";
    assert_eq!(idle(&[(line("junk one"), twice)]), ["LEX002 ; lexican: allow(INI001)"]);
    let covered = [
        (line("junk three"), "; lexican: allow(INI001)"),
        (line("[1016]"), "; lexican: allow(INI)"),
    ];
    assert_eq!(idle(&covered), ["LEX002 ; lexican: allow(INI)"]);
}

#[test]
fn a_rule_that_is_not_heard_or_looks_at_devices_is_not_called_idle() {
    let levels = Levels::default().with("INI=allow".parse().unwrap());
    assert_eq!(
        found_at(&[(line("junk one"), "; lexican: allow(INI001)")], &levels),
        [""; 0]
    );
    assert_eq!(found(&[(line("[1017]"), "; lexican: allow(DMP003)")]), ALL);
    assert_eq!(found(&[(1, "; lexican: allow-file(LEX002, INI001, OBJ003)")]), [""; 0]);
}

#[test]
fn an_unknown_name_allows_nothing_and_is_found_beside_known_ones() {
    let comment = (line("junk one"), "; lexican: allow(INI001, NIX001)");
    assert_eq!(
        found(&[comment]),
        ["LEX001 ; lexican: allow(INI001, NIX001)", ALL[1], ALL[2]]
    );
}

#[test]
fn many_comments_take_as_long_as_they_are() {
    let comments = "; lexican: allow(INI001)\n".repeat(100_000);
    let of_many = found(&[(line("junk one"), &comments)]);
    assert_eq!(of_many.len(), 2 + 10_000, "of one rule no more are kept");
    let one_line = format!("; {}", "lexican: ".repeat(1_000_000));
    assert_eq!(found(&[(line("junk one"), &one_line)]).len(), 1 + ALL.len());
}
