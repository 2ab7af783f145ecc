//! Each rule of family DMP finds what its fixture shows, and nothing in the fixture's cure.

use std::fs;

use lexican_eds::{
    Reading,
    diagnostic::{Code, Diagnostic},
    dump::Dump,
    render::Renderer,
    rules::{self, Levels, Rule},
};
use lexican_tests::fixture;

fn read(name: &str) -> Vec<u8> {
    let path = fixture::path(name);
    fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn validate(reading: &Reading, dump: &str) -> Vec<Diagnostic> {
    let dump = Dump::from_json(&read(dump)).unwrap_or_else(|error| panic!("{dump}:{error}"));
    rules::validate(reading, &dump, &Levels::default())
}

fn codes() -> impl Iterator<Item = &'static str> {
    let codes = rules::all().iter().map(Rule::code);
    codes.filter(|code| code.family() == "DMP").map(Code::as_str)
}

#[test]
fn each_rule_finds_what_its_fixture_shows_and_nothing_in_the_cure() {
    for code in codes() {
        let reading = fixture::read(code);
        let found = validate(&reading, &format!("{code}.json"));
        let renderer = Renderer::plain();
        let text: Vec<String> = found
            .iter()
            .map(|diagnostic| renderer.render(reading.document.source(), diagnostic))
            .collect();
        assert!(!found.is_empty(), "{code} is not found");
        assert!(
            found.iter().all(|diagnostic| diagnostic.code.as_str() == code),
            "{code}: {found:#?}"
        );
        assert_eq!(
            validate(&reading, &format!("{code}.fixed.json")),
            [],
            "{code}.fixed.json"
        );
        insta::assert_snapshot!(code, text.join("\n"));
    }
}

#[test]
fn the_fixtures_files_are_good_themselves() {
    for code in codes() {
        let reading = fixture::read(code);
        assert_eq!(rules::check(&reading, &Levels::default()), [], "{code}");
    }
}

#[test]
fn each_finding_says_how_to_mend_it_in_the_grammar_of_messages() {
    for code in codes() {
        let reading = fixture::read(code);
        for diagnostic in validate(&reading, &format!("{code}.json")) {
            let help = diagnostic.help.unwrap_or_else(|| panic!("{code} has no cure"));
            assert!(
                help.starts_with(|c: char| c.is_lowercase()),
                "{code}: `{help}` is no part of a sentence"
            );
            for text in [diagnostic.message, help] {
                assert!(!text.ends_with('.'), "{code}: `{text}` ends in a full stop");
            }
        }
    }
}
