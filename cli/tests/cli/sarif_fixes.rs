//! The cures in SARIF, made by a reader of their own, give what `--fix` gives.

use std::fs;

use serde_json::Value;

use crate::{formats::valid_sarif, lexican::Lexican};

/// The offset of line and column, both from 1; the line behind the last one starts at the end.
fn offset(text: &str, line: &Value, column: &Value) -> usize {
    let number = |value: &Value| usize::try_from(value.as_u64().unwrap()).unwrap();
    let lines = text.split_inclusive('\n').take(number(line) - 1);
    let start = lines.map(str::len).sum::<usize>();
    let before = text[start..].chars().take(number(column) - 1);
    start + before.map(char::len_utf8).sum::<usize>()
}

/// `text` with the replacements of `fix` made, the last one first.
fn made(text: &str, fix: &Value) -> String {
    let replacements = fix["artifactChanges"][0]["replacements"].as_array().unwrap();
    replacements.iter().rev().fold(text.to_owned(), |text, replacement| {
        let region = &replacement["deletedRegion"];
        let start = offset(&text, &region["startLine"], &region["startColumn"]);
        let end = offset(&text, &region["endLine"], &region["endColumn"]);
        let inserted = replacement["insertedContent"]["text"].as_str().unwrap_or_default();
        format!("{}{inserted}{}", &text[..start], &text[end..])
    })
}

/// The fixes of the only finding in `text`, and what `--fix` makes of it.
fn offered(text: &str) -> (Value, String) {
    let lexican = Lexican::with(&[("a.eds", text.as_bytes())]);
    let log = valid_sarif(&lexican.run(&["check", "a.eds", "--format", "sarif"]).stdout);
    let results = log["runs"][0]["results"].as_array().unwrap();
    assert_eq!(results.len(), 1, "{results:#?}");
    lexican.run(&["check", "--fix", "a.eds"]);
    let fixed = fs::read_to_string(lexican.path().join("a.eds")).unwrap();
    (results[0]["fixes"].clone(), fixed)
}

fn fixture(code: &str) -> String {
    let path = format!("{}/../tests/fixtures/rules/{code}.eds", env!("CARGO_MANIFEST_DIR"));
    fs::read_to_string(path).unwrap()
}

#[test]
fn a_cure_in_sarif_gives_what_fix_gives() {
    // A value, a keyword that is missing, a list's count, a section at the end, a comment that moves.
    for code in [
        "EDS017", "EDS012", "OBJ027", "EDS005", "OBJ009", "INI008", "EDS025", "INI010",
    ] {
        for text in [fixture(code), fixture(code).replace('\n', "\r\n")] {
            let (offer, fixed) = offered(&text);
            assert_eq!(made(&text, &offer[0]), fixed, "{code}");
            assert_ne!(fixed, text, "{code}");
        }
    }
}

#[test]
fn a_finding_without_a_cure_and_one_about_a_whole_list_offer_nothing() {
    for code in ["OBJ002", "EDS006"] {
        assert_eq!(offered(&fixture(code)).0, Value::Null, "{code}");
    }
}
