//! `lexican generate`

use std::fs;

use crate::lexican::{Lexican, Ran};

const WDGA: &[u8] = include_bytes!("../../../eds/devices/wdga.eds");
/// One finding at deny.
const DENIED: &[u8] = include_bytes!("../../../tests/fixtures/rules/OBJ002.eds");
/// One finding at warn.
const WARNED: &[u8] = include_bytes!("../../../tests/fixtures/rules/EDS005.eds");

fn files() -> Lexican {
    Lexican::with(&[("wdga.eds", WDGA), ("denied.eds", DENIED), ("warned.eds", WARNED)])
}

/// What is in the directory, by name.
fn names(lexican: &Lexican) -> Vec<String> {
    let files = fs::read_dir(lexican.path()).unwrap();
    let mut names: Vec<String> = files
        .map(|file| file.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn the_source_goes_to_standard_output() {
    let ran = files().run(&["generate", "wdga.eds"]);
    let source = ran.printed(0);
    assert!(source.contains("pub mod wdga {"), "{source}");
    assert!(source.contains("pub struct Dictionary"), "{source}");
}

#[test]
fn the_same_source_goes_to_a_file_and_nothing_is_printed() {
    let lexican = files();
    let printed = lexican.run(&["generate", "wdga.eds"]);
    let ran = lexican.run(&["generate", "wdga.eds", "-o", "wdga.rs"]);
    assert_eq!(ran.printed(0), "");
    assert_eq!(
        fs::read_to_string(lexican.path().join("wdga.rs")).unwrap(),
        printed.stdout
    );
    assert_eq!(names(&lexican), ["denied.eds", "warned.eds", "wdga.eds", "wdga.rs"]);
}

#[test]
fn a_dash_is_standard_input_and_output() {
    let lexican = files();
    let arguments = ["generate", "-", "--module", "wdga", "-o", "-"];
    let ran = lexican.run_with_input(&arguments, WDGA);
    assert!(ran.printed(0).contains("pub mod wdga {"), "{}", ran.stdout);
}

#[test]
fn stubs_are_for_the_handled_objects() {
    let ran = files().run(&[
        "generate",
        "wdga.eds",
        "--stubs",
        "--handle",
        "6003,0x6004",
        "--handle",
        "1010:1",
    ]);
    let stubs = ran.printed(0);
    assert!(stubs.contains("impl"), "{stubs}");
    assert!(stubs.contains("preset_value"), "{stubs}");
}

#[test]
fn stubs_without_handlers_say_that_there_is_nothing_to_write() {
    let ran = files().run(&["generate", "wdga.eds", "--stubs"]);
    assert!(ran.printed(0).contains("No object was named"), "{}", ran.stdout);
}

#[test]
fn the_documentation_is_markdown() {
    let ran = files().run(&["generate", "wdga.eds", "--docs"]);
    assert!(ran.printed(0).starts_with("# "), "{}", ran.stdout);
}

#[test]
fn a_template_of_the_user_s_own_is_filled() {
    let lexican = Lexican::with(&[
        ("wdga.eds", WDGA),
        (
            "list.j2",
            b"{% for object in objects %}{{ object.index | hex(4) }} {% endfor %}",
        ),
        ("wrong.j2", b"one\n{{ nothing }}"),
        ("binary.j2", b"\xFF\xFE"),
    ]);
    let ran = lexican.run(&["generate", "wdga.eds", "--template", "list.j2"]);
    assert!(ran.printed(0).starts_with("1000 1001 "), "{}", ran.stdout);

    let wrong = lexican.run(&["generate", "wdga.eds", "--template", "wrong.j2", "-o", "out.txt"]);
    assert!(wrong.failed().starts_with("error: wrong.j2:2: "), "{}", wrong.stderr);
    assert!(!names(&lexican).contains(&"out.txt".to_owned()));

    let missing = lexican.run(&["generate", "wdga.eds", "--template", "missing.j2"]);
    assert_eq!(
        missing.failed(),
        "error: cannot read missing.j2: there is no such file or directory\n"
    );
    let binary = lexican.run(&["generate", "wdga.eds", "--template", "binary.j2"]);
    assert_eq!(binary.failed(), "error: cannot read binary.j2: it is not UTF-8 text\n");
}

#[test]
fn a_denied_file_is_refused_with_its_findings_and_writes_nothing() {
    let lexican = files();
    let ran = lexican.run(&["generate", "denied.eds", "-o", "out.rs"]);
    assert_eq!((ran.code, ran.stdout.as_str()), (Some(1), ""));
    insta::assert_snapshot!("refused", ran.stderr);
    assert!(!names(&lexican).contains(&"out.rs".to_owned()));
}

#[test]
fn a_level_lets_a_denied_file_pass() {
    let ran = files().run(&["generate", "denied.eds", "--level", "OBJ002=warn"]);
    assert_eq!(ran.code, Some(0), "{ran:#?}");
    assert_eq!(ran.stderr, "denied.eds: 1 warning; `lexican check` shows them\n");
    assert!(ran.stdout.contains("pub mod denied {"), "{}", ran.stdout);
}

#[test]
fn warnings_are_counted_and_do_not_stop() {
    let ran = files().run(&["generate", "warned.eds"]);
    assert_eq!(ran.code, Some(0), "{ran:#?}");
    assert_eq!(ran.stderr, "warned.eds: 1 warning; `lexican check` shows them\n");
}

#[test]
fn what_cannot_be_read_is_named() {
    let lexican = Lexican::with(&[("folder/wdga.eds", WDGA)]);
    assert_eq!(
        lexican.run(&["generate", "missing.eds"]).failed(),
        "error: cannot read missing.eds: there is no such file or directory\n"
    );
    assert_eq!(
        lexican.run(&["generate", "folder"]).failed(),
        "error: cannot read folder: it is a directory; name a file\n"
    );
}

#[test]
fn a_binary_is_refused_as_no_description() {
    let ran = Lexican::with(&[("a.out", &[0x7F, b'E', b'L', b'F', 0, 1, 0, 0, 0xFF])]).run(&["generate", "a.out"]);
    assert_eq!(ran.code, Some(1));
    assert!(ran.stderr.contains("error[INI014]"), "{}", ran.stderr);
}

#[test]
fn objects_that_are_not_there_and_indices_that_are_none_are_refused() {
    let handle = |object: &str| -> Ran { files().run(&["generate", "wdga.eds", "--handle", object]) };
    assert!(handle("5FFF").failed().starts_with("error: 5FFFh is not in wdga.eds"));
    assert_eq!(
        handle("position").failed(),
        "error: --handle position: write an index, such as 6003, or index and sub-index, such as 1010:1\n"
    );
    handle("1018:100").failed();
    handle("12345").failed();
}

#[test]
fn an_unwritable_target_is_named_and_nothing_is_left() {
    let lexican = Lexican::with(&[("wdga.eds", WDGA), ("folder/x", b""), ("old.rs", b"// mine\n")]);
    let write = |target: &str| -> Ran { lexican.run(&["generate", "wdga.eds", "-o", target]) };
    assert_eq!(
        write("nowhere/out.rs").failed(),
        "error: cannot write nowhere/out.rs: there is no such file or directory\n"
    );
    assert_eq!(
        write("folder").failed(),
        "error: cannot write folder: it is a directory; name a file\n"
    );
    let old = lexican.path().join("old.rs");
    let mut permissions = fs::metadata(&old).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&old, permissions).unwrap();
    assert_eq!(
        write("old.rs").failed(),
        "error: cannot write old.rs: permission denied\n"
    );
    assert_eq!(fs::read(&old).unwrap(), b"// mine\n");
    assert_eq!(names(&lexican), ["folder", "old.rs", "wdga.eds"]);
}

#[test]
fn an_existing_file_is_replaced() {
    let lexican = Lexican::with(&[("wdga.eds", WDGA), ("out.rs", b"// old\n")]);
    lexican.run(&["generate", "wdga.eds", "-o", "out.rs"]).printed(0);
    let source = fs::read_to_string(lexican.path().join("out.rs")).unwrap();
    assert!(source.contains("pub mod wdga {"), "{source}");
}

#[cfg(unix)]
#[test]
fn a_written_file_is_as_readable_as_any_and_a_link_stays_one() {
    use std::os::unix::fs::{PermissionsExt as _, symlink};

    let lexican = Lexican::with(&[("wdga.eds", WDGA), ("real.rs", b"")]);
    let path = |name: &str| lexican.path().join(name);
    symlink(path("real.rs"), path("link.rs")).unwrap();
    lexican.run(&["generate", "wdga.eds", "-o", "link.rs"]).printed(0);
    lexican.run(&["generate", "wdga.eds", "-o", "new.rs"]).printed(0);
    assert!(fs::symlink_metadata(path("link.rs")).unwrap().is_symlink());
    assert_eq!(fs::read(path("real.rs")).unwrap(), fs::read(path("new.rs")).unwrap());
    fs::write(path("any"), b"").unwrap();
    let mode = |name: &str| fs::metadata(path(name)).unwrap().permissions().mode();
    assert_eq!(mode("new.rs"), mode("any"));
}
