//! `lexican check --fix` and `--diff`

use std::{fs, process::Command};

use crate::lexican::Lexican;

/// SupportedObjects is 1, two objects are listed.
const COUNT: &[u8] = include_bytes!("../../../tests/fixtures/rules/EDS005.eds");
/// One finding at deny that no fix mends.
const DENIED: &[u8] = include_bytes!("../../../tests/fixtures/rules/OBJ002.eds");
const GOOD: &[u8] = include_bytes!("../../../tests/fixtures/rules/INI001.fixed.eds");

fn read(lexican: &Lexican, name: &str) -> Vec<u8> {
    fs::read(lexican.path().join(name)).unwrap()
}

#[test]
fn fix_mends_the_file_and_says_what_is_left() {
    let lexican = Lexican::with(&[("count.eds", COUNT), ("denied.eds", DENIED), ("good.eds", GOOD)]);
    let before = lexican.run(&["check", "count.eds"]);
    assert!(
        before
            .printed(0)
            .ends_with("\n`--fix` mends 1 of them, `--diff` shows how\n"),
        "{}",
        before.stdout
    );
    let ran = lexican.run(&["check", "--fix", "count.eds", "denied.eds", "good.eds"]);
    assert!(
        ran.printed(1).ends_with("\n3 files checked: 1 error; 1 fixed\n"),
        "{}",
        ran.stdout
    );
    assert_eq!(read(&lexican, "denied.eds"), DENIED);
    assert_eq!(read(&lexican, "good.eds"), GOOD);
    let again = lexican.run(&["check", "--fix", "count.eds"]);
    assert_eq!(again.printed(0), "1 file checked: no findings\n");
}

#[test]
fn an_allowed_rule_is_not_fixed() {
    let lexican = Lexican::with(&[("count.eds", COUNT)]);
    lexican
        .run(&["check", "--fix", "count.eds", "--level", "EDS005=allow"])
        .printed(0);
    assert_eq!(read(&lexican, "count.eds"), COUNT);
}

#[test]
fn the_diff_is_what_patch_makes_the_fixed_file_of() {
    let lexican = Lexican::with(&[("count.eds", COUNT)]);
    let shown = lexican.run(&["check", "--diff", "count.eds"]);
    assert_eq!(shown.code, Some(1));
    assert_eq!(shown.stderr, "note: `--fix` mends 1 finding in 1 file\n");
    assert_eq!(read(&lexican, "count.eds"), COUNT);
    fs::write(lexican.path().join("fix.diff"), &shown.stdout).unwrap();
    lexican.run(&["check", "--fix", "count.eds"]).printed(0);
    let fixed = read(&lexican, "count.eds");
    fs::write(lexican.path().join("count.eds"), COUNT).unwrap();
    let patch = Command::new("patch")
        .args(["--binary", "count.eds", "fix.diff"])
        .current_dir(lexican.path())
        .output();
    // A machine without `patch` has the rest of the test.
    if let Ok(patched) = patch {
        assert!(patched.status.success(), "{patched:?}");
        assert_eq!(read(&lexican, "count.eds"), fixed);
    }
    assert!(shown.stdout.contains("\n-SupportedObjects="), "{}", shown.stdout);
}

#[test]
fn there_is_no_diff_of_what_needs_no_fix() {
    let lexican = Lexican::with(&[("good.eds", GOOD)]);
    assert_eq!(lexican.run(&["check", "--diff", "good.eds"]).printed(0), "");
}

#[test]
fn standard_input_is_fixed_to_standard_output() {
    let lexican = Lexican::with(&[("count.eds", COUNT)]);
    let ran = lexican.run_with_input(&["check", "--fix", "-"], COUNT);
    assert_eq!(
        (ran.code, ran.stderr.as_str()),
        (Some(0), "note: 1 fixed; left: no findings\n")
    );
    lexican.run(&["check", "--fix", "count.eds"]).printed(0);
    assert_eq!(ran.stdout.as_bytes(), read(&lexican, "count.eds"));
}

#[test]
fn standard_input_beside_files_cannot_be_fixed() {
    let lexican = Lexican::with(&[("count.eds", COUNT)]);
    let ran = lexican.run(&["check", "--fix", "-", "count.eds"]);
    assert!(ran.failed().contains("name `-` alone"), "{}", ran.stderr);
}

#[cfg(unix)]
#[test]
fn permissions_stay_and_a_link_stays_a_link() {
    use std::os::unix::fs::{PermissionsExt as _, symlink};
    let lexican = Lexican::with(&[("count.eds", COUNT)]);
    let (file, link) = (lexican.path().join("count.eds"), lexican.path().join("link.eds"));
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    symlink("count.eds", &link).unwrap();
    lexican.run(&["check", "--fix", "link.eds"]).printed(0);
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o640);
    assert_ne!(read(&lexican, "count.eds"), COUNT);
    assert_eq!(fs::read_dir(lexican.path()).unwrap().count(), 2);
}

#[test]
fn a_file_that_cannot_be_written_is_named() {
    let lexican = Lexican::with(&[("count.eds", COUNT)]);
    let path = lexican.path().join("count.eds");
    let mut permissions = fs::metadata(&path).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&path, permissions).unwrap();
    let ran = lexican.run(&["check", "--fix", "--quiet", "count.eds"]);
    assert_eq!(
        (ran.code, ran.stderr.as_str()),
        (Some(2), "error: cannot write count.eds: permission denied\n")
    );
}
