//! `lexican explain`

use std::fs;

use crate::lexican::Lexican;

fn explain(arguments: &[&str]) -> crate::lexican::Ran {
    let command = [&["explain"], arguments].concat();
    Lexican::with(&[]).run(&command)
}

#[test]
fn a_code_gives_the_rules_page() {
    insta::assert_snapshot!("OBJ002", explain(&["OBJ002"]).printed(0));
}

#[test]
fn a_code_may_be_in_small_letters() {
    assert_eq!(explain(&["obj002"]), explain(&["OBJ002"]));
}

#[test]
fn a_family_gives_its_rules() {
    insta::assert_snapshot!("INI", explain(&["INI"]).printed(0));
}

#[test]
fn without_a_code_it_lists_each_rule_of_each_family() {
    let ran = explain(&[]);
    let text = ran.printed(0);
    for rule in lexican_eds::rules::all() {
        let row = format!("{}  {:<4}  {}\n", rule.code(), rule.level(), rule.name());
        assert!(text.contains(&row), "{row}");
    }
}

#[test]
fn all_pages_are_the_manual_of_the_docs() {
    let manual = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/rules.md");
    assert_eq!(explain(&["--all"]).printed(0), fs::read_to_string(manual).unwrap());
}

#[test]
fn headings_are_bold_where_colour_is_wanted_and_examples_are_not() {
    let ran = explain(&["INI013", "--color", "always"]);
    let text = ran.printed(0);
    assert!(text.contains("\u{1b}[1m## Example\u{1b}[0m\n"), "{text}");
    assert!(text.contains("\n# the newest error\n"), "{text}");
}

#[test]
fn an_unknown_code_is_refused_with_a_similar_one() {
    assert_eq!(
        explain(&["OBJ02"]).failed(),
        "error: unknown rule `OBJ02`; did you mean OBJ002?\n"
    );
    assert_eq!(
        explain(&["pump.eds"]).failed(),
        "error: unknown rule `pump.eds`; `lexican explain` lists them all\n"
    );
}

#[test]
fn it_is_an_option_as_well_as_in_rustc() {
    let ran = Lexican::with(&[]).run(&["--explain", "OBJ002"]);
    assert_eq!(ran, explain(&["OBJ002"]));
    let ran = Lexican::with(&[]).run(&["--color", "never"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.starts_with("error: a command is missing"), "{}", ran.stderr);
}
