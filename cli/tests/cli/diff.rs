//! `lexican diff`

use crate::lexican::Lexican;

const PAGE: &str = include_str!("../../../docs/json.md");
const OTHER: &[u8] = include_bytes!("../../../tests/fixtures/rules/OBJ002.eds");

/// What stands in the first block that starts with `start` behind `above`.
fn block(above: &str, start: &str) -> &'static str {
    let (_, rest) = PAGE.split_once(above).unwrap();
    let (_, rest) = rest.split_once(start).unwrap();
    rest.split_once("```").unwrap().0
}

fn pumps() -> Lexican {
    let old = block("lexican diff", "```ini\n");
    let new = block("and `pump-2.eds`", "```ini\n");
    Lexican::with(&[
        ("pump-1.eds", old.as_bytes()),
        ("pump-2.eds", new.as_bytes()),
        ("other.eds", OTHER),
    ])
}

#[test]
fn the_json_is_what_its_description_shows() {
    let ran = pumps().run(&["diff", "pump-1.eds", "pump-2.eds", "--format", "json"]);
    assert_eq!(ran.printed(1), block("and `pump-2.eds`", "```json\n"));
}

#[test]
fn differences_are_a_line_each_breaking_ones_first() {
    let ran = pumps().run(&["diff", "pump-1.eds", "pump-2.eds"]);
    insta::assert_snapshot!("diff", ran.printed(1));
}

#[test]
fn the_exit_code_says_whether_they_differ_in_what_is_asked_for() {
    let lexican = pumps();
    let stdin = block("lexican diff", "```ini\n");
    let same = lexican.run_with_input(&["diff", "pump-1.eds", "-"], stdin.as_bytes());
    assert_eq!(same.printed(0), "pump-1.eds → <stdin>: no difference\n");
    let breaking = ["diff", "--min-effect", "breaking", "pump-1.eds", "pump-2.eds"];
    assert_eq!(lexican.run(&breaking).printed(1).lines().count(), 2);
    let reverse = ["diff", "--min-effect", "addition", "pump-2.eds", "pump-1.eds"];
    lexican.run(&reverse).printed(1);
}

#[test]
fn what_is_no_description_is_refused() {
    let lexican = Lexican::with(&[("a.eds", OTHER), ("b.json", b"{}")]);
    assert!(
        lexican
            .run(&["diff", "a.eds", "b.json"])
            .failed()
            .contains("b.json describes no object")
    );
    assert!(
        lexican
            .run(&["diff", "a.eds", "none.eds"])
            .failed()
            .contains("none.eds")
    );
    assert!(
        lexican
            .run(&["diff", "a.eds", "a.eds"])
            .failed()
            .contains("name two files")
    );
}
