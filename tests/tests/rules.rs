//! Each rule finds what its fixture shows, and nothing in the fixture's cure; each is documented.
//!
//! The rules about dumps (family DMP) are in `dump_rules.rs`.

use std::{
    collections::BTreeSet,
    fs,
    path::{Path, PathBuf},
};

use lexican_eds::{
    Reading,
    diagnostic::Diagnostic,
    render::Renderer,
    rules::{self, Rule},
};
use lexican_tests::levels::every_rule;

use lexican_tests::fixture::read;

fn root(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)
}

fn check(reading: &Reading) -> Vec<Diagnostic> {
    rules::check(reading, &every_rule())
}

/// The rules that look at files.
fn rules_about_files() -> impl Iterator<Item = &'static Rule> {
    rules::all().iter().filter(|rule| rule.code().family() != "DMP")
}

#[test]
fn each_rule_finds_what_its_fixture_shows_once_and_nothing_else() {
    for code in rules_about_files().map(Rule::code) {
        let reading = read(code.as_str());
        let found = check(&reading);
        let codes: Vec<&str> = found.iter().map(|diagnostic| diagnostic.code.as_str()).collect();
        assert_eq!(codes, [code.as_str()], "{code}");
        let text = Renderer::plain().render(reading.document.source(), &found[0]);
        insta::assert_snapshot!(code.as_str(), text);
    }
}

#[test]
fn nothing_is_found_in_the_cure() {
    for code in rules_about_files().map(Rule::code) {
        let name = format!("{code}.fixed");
        assert_eq!(check(&read(&name)), [], "{name}");
    }
}

#[test]
fn each_fixture_belongs_to_a_rule() {
    let codes: BTreeSet<&str> = rules::all().iter().map(|rule| rule.code().as_str()).collect();
    for file in fs::read_dir(root("tests/fixtures/rules")).unwrap() {
        let name = file.unwrap().file_name().into_string().unwrap();
        let code = name.split('.').next().unwrap();
        assert!(codes.contains(code), "{name} shows a rule that does not exist");
    }
}

#[test]
fn each_finding_says_how_to_mend_it_in_the_grammar_of_messages() {
    for code in rules_about_files().map(Rule::code) {
        for diagnostic in check(&read(code.as_str())) {
            let message = &diagnostic.message;
            assert!(!message.ends_with('.'), "{code}: `{message}` ends in a full stop");
            let help = diagnostic.help.unwrap_or_else(|| panic!("{code} has no cure"));
            assert!(!help.ends_with('.'), "{code}: `{help}` ends in a full stop");
            assert!(
                help.starts_with(|c: char| c.is_lowercase()),
                "{code}: `{help}` is no part of a sentence"
            );
        }
    }
}

#[test]
fn each_rule_is_documented_under_the_same_headings() {
    for rule in rules::all() {
        let page = rule.documentation();
        let headings: Vec<&str> = page.lines().filter(|line| line.starts_with("## ")).collect();
        let expected = ["## What it does", "## Why it matters", "## Example", "## Reference"];
        assert_eq!(headings, expected, "{}", rule.code());
        assert!(rule.summary().ends_with('.'), "{}: {}", rule.code(), rule.summary());
    }
}

#[test]
fn the_manual_of_rules_is_fresh() {
    let manual = fs::read_to_string(root("docs/rules.md")).unwrap_or_default();
    assert!(
        manual == rules::manual(),
        "docs/rules.md is stale: run `cargo run -p lexican -- explain --all > docs/rules.md`"
    );
}

#[test]
fn findings_come_in_the_order_of_the_file_and_then_of_the_codes() {
    let text = "[1017]\nObjectType=0x7\nDataType=0x0006\nAccessType=RW\n[FileInfo]\nFileRevision=08\n";
    let found = check(&lexican_eds::read("x.eds", text.into()));
    let order: Vec<_> = found
        .iter()
        .map(|diagnostic| (diagnostic.span.start, diagnostic.code.as_str()))
        .collect();
    assert!(order.is_sorted(), "{order:?}");
    assert!(order.len() > 5, "{order:?}");
}

#[test]
fn of_one_rule_as_many_are_kept_as_somebody_may_read() {
    let junk = |lines: usize| {
        let text = format!("[FileInfo]\n{}", "junk\n".repeat(lines));
        let found = check(&lexican_eds::read("x.eds", text.into()));
        let junk = found.into_iter().filter(|finding| finding.code.as_str() == "INI001");
        junk.map(|finding| finding.message).collect::<Vec<_>>()
    };
    assert_eq!(junk(10_000).last().unwrap(), "line `junk` has no `=`");
    let found = junk(12_345);
    assert_eq!(found.len(), 10_000);
    assert_eq!(
        found.last().unwrap(),
        "line `junk` has no `=` (and 2345 more in this file)"
    );
}

#[test]
fn what_stands_for_too_much_is_one_finding_an_object() {
    let connected: Vec<String> = (1..=200).map(|place| format!("{place}=1\n")).collect();
    let module = "[M1SubExt2000]\nParameterName=Channel\nDataType=0x0005\nAccessType=ro\nCount=200\nObjExtend=254\n";
    let object = |index| format!("[{index:04X}]\nObjectType=0x8\nDataType=0x0005\nAccessType=ro\nCompactSubObj=254\n");
    let objects: Vec<String> = (0x3000..0x3800).map(object).collect();
    let text = format!("[ConnectedModules]\n{}{module}{}", connected.concat(), objects.concat());
    let reading = lexican_eds::read("x.dcf", text.into());
    let found = check(&reading);
    let crowded: Vec<_> = found
        .iter()
        .filter(|diagnostic| diagnostic.code.as_str() == "EDS030")
        .collect();
    assert!(!crowded.is_empty());
    let places: BTreeSet<_> = crowded.iter().map(|diagnostic| diagnostic.span.start).collect();
    assert_eq!(places.len(), crowded.len(), "{crowded:#?}");
}
