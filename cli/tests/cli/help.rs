//! What the command says of itself.

use crate::lexican::Lexican;

fn help(arguments: &[&str]) -> String {
    Lexican::with(&[]).run(arguments).printed(0).to_owned()
}

#[test]
fn the_help_names_each_command() {
    insta::assert_snapshot!("lexican", help(&["--help"]));
    insta::assert_snapshot!("check", help(&["check", "--help"]));
    insta::assert_snapshot!("explain", help(&["explain", "--help"]));
    insta::assert_snapshot!("generate", help(&["generate", "--help"]));
    insta::assert_snapshot!("new", help(&["new", "--help"]));
    insta::assert_snapshot!("validate", help(&["validate", "--help"]));
}

#[test]
fn the_version_is_that_of_the_package() {
    assert_eq!(
        help(&["--version"]),
        concat!("lexican ", env!("CARGO_PKG_VERSION"), "\n")
    );
}

#[test]
fn without_arguments_the_help_goes_to_stderr() {
    let ran = Lexican::with(&[]).run(&[]);
    assert_eq!(ran.code, Some(2));
    assert_eq!(ran.stdout, "");
    assert!(ran.stderr.contains("Usage: lexican"), "{}", ran.stderr);
}

#[test]
fn an_unknown_command_is_answered_with_a_similar_one() {
    let ran = Lexican::with(&[]).run(&["chekc"]);
    assert_eq!(ran.code, Some(2));
    assert!(ran.stderr.contains("'check'"), "{}", ran.stderr);
}
