//! The formats for programs, read by parsers that are not ours.

use roxmltree::{Document, Node};
use serde_json::Value;

use crate::lexican::{Lexican, Ran};

const GOOD: &[u8] = include_bytes!("../../../tests/fixtures/rules/INI001.fixed.eds");
/// One finding at deny, with a related place.
const DENIED: &[u8] = include_bytes!("../../../tests/fixtures/rules/OBJ002.eds");
/// One finding at warn.
const WARNED: &[u8] = include_bytes!("../../../tests/fixtures/rules/EDS005.eds");
/// One finding at note.
const NOTED: &[u8] = include_bytes!("../../../tests/fixtures/rules/OBJ013.eds");
/// Control characters, markup and two characters that XML does not know, in what messages quote.
const HOSTILE: &[u8] =
    "[FileInfo]\nFile\x1b[2JVersion=\x1b[31m1\n<b>&amp;]]>\u{FFFE}\u{FFFF}\u{0}{0} %0A::error::\n".as_bytes();

fn devices() -> Lexican {
    Lexican::with(&[
        ("devices/a good.eds", GOOD),
        ("devices/denied.eds", DENIED),
        ("devices/noted.eds", NOTED),
        ("devices/warned.eds", WARNED),
        ("hostile.eds", HOSTILE),
        ("empty.eds", b""),
    ])
}

/// All of [`devices`], a file without a place to point at, and one that is missing.
fn run(format: &str) -> Ran {
    let arguments = [
        "check",
        "devices",
        "hostile.eds",
        "empty.eds",
        "missing.eds",
        "--format",
        format,
    ];
    let ran = devices().run(&arguments);
    assert_eq!(ran.code, Some(2), "{ran:#?}");
    ran
}

/// What the schema of OASIS has against `log`.
fn sarif_errors(log: &Value) -> Vec<String> {
    // A bracket too many in two patterns about languages is no regular expression to today's readers of schemas.
    let schema = include_str!("../schemas/sarif-2.1.0.json").replace("[a-zA-Z]{2}]?$", "[a-zA-Z]{2}$");
    let schema = serde_json::from_str(&schema).unwrap();
    let options = jsonschema::options().should_validate_formats(true);
    let errors = |error: jsonschema::ValidationError| format!("{}: {error}", error.instance_path());
    options.build(&schema).unwrap().iter_errors(log).map(errors).collect()
}

pub(crate) fn valid_sarif(text: &str) -> Value {
    let log = serde_json::from_str(text).unwrap();
    assert_eq!(sarif_errors(&log), [""; 0]);
    log
}

#[test]
fn the_sarif_is_valid_by_the_schema_of_oasis() {
    valid_sarif(&run("sarif").stdout);
    valid_sarif(
        devices()
            .run(&["check", "devices/a good.eds", "--format", "sarif"])
            .printed(0),
    );
    valid_sarif(&devices().run(&["check", "missing.eds", "--format", "sarif"]).stdout);
}

#[test]
fn the_schema_finds_what_is_no_sarif() {
    let mut log = valid_sarif(&run("sarif").stdout);
    log["runs"][0]["results"][0]["level"] = "fatal".into();
    assert_eq!(sarif_errors(&log).len(), 1);
}

#[test]
fn sarif_says_where_how_grave_and_by_which_rule() {
    let log = valid_sarif(&run("sarif").stdout);
    let run = &log["runs"][0];
    let results = run["results"].as_array().unwrap();
    let denied = results.iter().find(|result| result["ruleId"] == "OBJ002").unwrap();
    assert_eq!(denied["level"], "error");
    let location = &denied["locations"][0]["physicalLocation"];
    assert_eq!(location["artifactLocation"]["uri"], "devices/denied.eds");
    assert_eq!(
        location["region"],
        serde_json::json!({"startLine": 93, "startColumn": 10, "endColumn": 13})
    );
    let related = &denied["relatedLocations"][0];
    assert_eq!(related["physicalLocation"]["region"]["startLine"], 94);
    assert_eq!(related["message"]["text"], "the HighLimit");

    let rules = run["tool"]["driver"]["rules"].as_array().unwrap();
    let rule = rules.iter().find(|rule| rule["id"] == "OBJ002").unwrap();
    assert_eq!(rule["defaultConfiguration"]["level"], "error");
    let help = rule["help"]["markdown"].as_str().unwrap();
    assert!(help.starts_with("# OBJ002: inverted limits\n"), "{help}");
    let uri = rule["helpUri"].as_str().unwrap();
    assert!(uri.ends_with("docs/rules.md#obj002-inverted-limits"), "{uri}");
    for result in results {
        assert!(rules.iter().any(|rule| rule["id"] == result["ruleId"]), "{result}");
    }
    assert_eq!(run["invocations"][0]["executionSuccessful"], false);
}

#[test]
fn a_fingerprint_stays_when_lines_move_and_differs_between_findings() {
    let twice = [DENIED, b"junk\njunk\n"].concat();
    let moved = [b"; one line\n; and another\n", twice.as_slice()].concat();
    let fingerprints = |text: &[u8]| -> Vec<String> {
        let lexican = Lexican::with(&[("a.eds", text)]);
        let log = valid_sarif(lexican.run(&["check", "a.eds", "--format", "sarif"]).printed(1));
        let results = log["runs"][0]["results"].as_array().unwrap().iter();
        results
            .map(|result| result["partialFingerprints"]["lexican/v1"].to_string())
            .collect()
    };
    let before = fingerprints(&twice);
    assert_eq!(before, fingerprints(&moved));
    assert_eq!(before.len(), 3);
    assert!(before[0] != before[1] && before[1] != before[2] && before[0] != before[2]);
}

#[test]
fn a_brace_of_the_file_is_no_placeholder_of_sarif() {
    let text = run("sarif").stdout;
    assert!(text.contains("{{0}}"), "{text}");
}

fn attribute(node: Node, name: &str) -> usize {
    node.attribute(name).unwrap().parse().unwrap()
}

fn children<'a>(node: Node<'a, 'a>, name: &'static str) -> impl Iterator<Item = Node<'a, 'a>> {
    node.descendants().filter(move |child| child.has_tag_name(name))
}

#[test]
fn the_junit_is_xml_whose_numbers_agree() {
    let ran = run("junit");
    let document = Document::parse(&ran.stdout).unwrap();
    let root = document.root_element();
    assert!(root.has_tag_name("testsuites"));
    let suites: Vec<Node> = children(root, "testsuite").collect();
    assert_eq!(suites.len(), 7, "six files, and what could not be read");
    for suite in &suites {
        assert_eq!(attribute(*suite, "tests"), children(*suite, "testcase").count());
        assert_eq!(attribute(*suite, "failures"), children(*suite, "failure").count());
        assert_eq!(attribute(*suite, "errors"), children(*suite, "error").count());
        assert!(children(*suite, "testcase").all(|case| case.attribute("name").is_some()));
    }
}

#[test]
fn the_junit_has_elements_and_attributes_that_the_schema_of_jenkins_knows() {
    let known = [
        ("testsuites", &["name"][..], &["testsuite"][..]),
        ("testsuite", &["name", "tests", "failures", "errors"], &["testcase"]),
        ("testcase", &["classname", "name"], &["failure", "error", "system-out"]),
        ("failure", &["type", "message"], &[]),
        ("error", &["type", "message"], &[]),
        ("system-out", &[], &[]),
    ];
    let ran = run("junit");
    let document = Document::parse(&ran.stdout).unwrap();
    for node in document.descendants().filter(Node::is_element) {
        let name = node.tag_name().name();
        let (_, attributes, children) = known.iter().find(|(known, ..)| *known == name).expect(name);
        assert!(
            node.attributes()
                .all(|attribute| attributes.contains(&attribute.name())),
            "{name}"
        );
        let mut inner = node.children().filter(Node::is_element);
        assert!(inner.all(|child| children.contains(&child.tag_name().name())), "{name}");
    }
}

#[test]
fn junit_fails_where_the_exit_code_does() {
    let of = |arguments: &[&str], code| {
        let arguments = [&["check", "--format", "junit"], arguments].concat();
        let text = devices().run(&arguments).printed(code).to_owned();
        let document = Document::parse(&text).unwrap();
        let count = |name| children(document.root_element(), name).count();
        (count("testcase"), count("failure"))
    };
    assert_eq!(of(&["devices/denied.eds"], 1), (1, 1));
    assert_eq!(of(&["devices/warned.eds"], 0), (1, 0));
    assert_eq!(of(&["devices/a good.eds"], 0), (1, 0));
    assert_eq!(of(&["devices/warned.eds", "--level", "EDS005=deny"], 1), (1, 1));
}

/// A workflow command, taken apart as the runner does it: properties up to `::`, then the escapes.
fn annotation(line: &str) -> (String, Vec<(String, String)>, String) {
    let (command, message) = line.strip_prefix("::").unwrap().split_once("::").unwrap();
    let (name, properties) = command.split_once(' ').unwrap();
    let unescape = |text: &str| {
        let text = text.replace("%0D", "\r").replace("%0A", "\n").replace("%3A", ":");
        text.replace("%2C", ",").replace("%25", "%")
    };
    let properties = properties.split(',').map(|property| {
        let (key, value) = property.split_once('=').unwrap();
        (key.to_owned(), unescape(value))
    });
    (name.to_owned(), properties.collect(), unescape(message))
}

#[test]
fn an_annotation_names_file_line_column_and_rule() {
    let ran = devices().run(&["check", "devices/denied.eds", "--format", "github"]);
    let mut lines = ran.printed(1).lines();
    let (name, properties, message) = annotation(lines.next().unwrap());
    assert_eq!(name, "error");
    let expected = [
        ("file", "devices/denied.eds"),
        ("line", "93"),
        ("col", "10"),
        ("endColumn", "13"),
        ("title", "OBJ002"),
    ];
    assert_eq!(
        properties,
        expected.map(|(key, value)| (key.to_owned(), value.to_owned()))
    );
    assert!(message.starts_with("LowLimit `127` is above HighLimit"), "{message}");
    assert!(message.contains("\nhelp: fix the limits"), "{message}");
    assert_eq!(lines.next(), Some("1 file checked: 1 error"));
}

#[test]
fn each_level_has_its_annotation() {
    let text = run("github").stdout;
    let starts = |start: &str| text.lines().filter(|line| line.starts_with(start)).count();
    assert_eq!(starts("::error file=devices/denied.eds,"), 1);
    assert_eq!(starts("::warning file=devices/warned.eds,"), 1);
    assert_eq!(starts("::notice file=devices/noted.eds,"), 1);
    assert_eq!(starts("::error file=empty.eds,title="), 1, "{text}");
    assert_eq!(starts("::error title=lexican::cannot read missing.eds"), 1);
    let others: Vec<&str> = text.lines().filter(|line| !line.starts_with("::")).collect();
    assert_eq!(others.len(), 1, "the summary alone: {text}");
}

#[cfg(unix)]
#[test]
fn a_file_name_cannot_break_out_of_its_annotation() {
    let name = "a,line=7::b%25\n::error::.eds";
    let ran = Lexican::with(&[(name, DENIED)]).run(&["check", name, "--format", "github"]);
    let (_, properties, _) = annotation(ran.printed(1).lines().next().unwrap());
    assert_eq!(properties[0].1, "a,line=7::b%25␊::error::.eds");
    assert_eq!(properties[1], ("line".to_owned(), "93".to_owned()));
    assert_eq!(ran.stdout.lines().count(), 2);
}

#[test]
fn control_characters_of_a_file_stay_out_of_every_format() {
    for format in ["text", "json", "sarif", "junit", "github", "html"] {
        let ran = run(format);
        let steering = |text: &str| text.chars().find(|c| c.is_control() && *c != '\n');
        assert_eq!(steering(&ran.stdout), None, "{format}: {}", ran.stdout);
        assert_eq!(steering(&ran.stderr), None, "{format}: {}", ran.stderr);
    }
}

#[test]
fn validate_has_the_same_formats() {
    let dump = include_bytes!("../../../tests/fixtures/rules/DMP001.json");
    let eds = include_bytes!("../../../tests/fixtures/rules/DMP001.eds");
    let lexican = Lexican::with(&[("pump.eds", eds), ("node.json", dump)]);
    let of = |format: &str| {
        lexican
            .run(&["validate", "pump.eds", "node.json", "--format", format])
            .stdout
    };
    let log = valid_sarif(&of("sarif"));
    assert_eq!(log["runs"][0]["results"][0]["ruleId"], "DMP001");
    assert!(of("github").contains("title=DMP001::"));
    let junit = of("junit");
    assert!(
        Document::parse(&junit)
            .unwrap()
            .descendants()
            .any(|node| node.attribute("name").is_some_and(|name| name.starts_with("DMP001")))
    );
}
