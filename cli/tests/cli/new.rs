//! `lexican new`

use std::{env, fs, path::Path, process::Command, sync::Mutex};

use crate::lexican::{Lexican, Ran};

const WDGA: &[u8] = include_bytes!("../../../eds/devices/wdga.eds");
/// One finding at deny.
const DENIED: &[u8] = include_bytes!("../../../tests/fixtures/rules/OBJ002.eds");
/// Where the crates that it is to depend on are.
const CHECKOUT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

fn files() -> Lexican {
    Lexican::with(&[
        ("wdga.eds", WDGA),
        ("denied.eds", DENIED),
        ("folder/x", b""),
        ("taken", b""),
    ])
}

/// What is in the directory and below, by name.
fn names(folder: &Path) -> Vec<String> {
    let walk = walkdir::WalkDir::new(folder).sort_by_file_name();
    let files = walk.into_iter().map(Result::unwrap);
    let files = files.filter(|entry| entry.file_type().is_file());
    let name = |path: &Path| path.strip_prefix(folder).unwrap().to_str().unwrap().to_owned();
    files.map(|entry| name(entry.path())).collect()
}

fn read(lexican: &Lexican, file: &str) -> String {
    fs::read_to_string(lexican.path().join(file)).unwrap()
}

#[test]
fn the_crate_has_what_firmware_needs_and_the_file_as_it_is() {
    let lexican = files();
    let ran = lexican.run(&["new", "encoder", "--eds", "wdga.eds"]);
    assert_eq!((ran.code, ran.stdout.as_str()), (Some(0), ""), "{ran:#?}");
    assert!(ran.stderr.starts_with("note: encoder is a firmware crate"), "{ran:#?}");
    let expected = [
        ".gitignore",
        "Cargo.toml",
        "README.md",
        "build.rs",
        "src/handlers.rs",
        "src/lib.rs",
        "src/main.rs",
        "tests/sdo.rs",
        "wdga.eds",
    ];
    assert_eq!(names(&lexican.path().join("encoder")), expected);
    assert_eq!(fs::read(lexican.path().join("encoder/wdga.eds")).unwrap(), WDGA);
    let manifest = read(&lexican, "encoder/Cargo.toml");
    assert!(manifest.contains("name = \"encoder\""), "{manifest}");
    let version = env!("CARGO_PKG_VERSION");
    assert!(
        manifest.contains(&format!("lexican-runtime = \"{version}\"")),
        "{manifest}"
    );
    assert!(
        manifest.contains(&format!("lexican-codegen = \"{version}\"")),
        "{manifest}"
    );
}

#[test]
fn handled_objects_levels_and_node_id_are_those_asked_for() {
    let lexican = files();
    let ran = lexican.run(&[
        "new",
        "folder/pump-2",
        "--eds",
        "denied.eds",
        "--level",
        "OBJ002=warn",
        "--handle",
        "2000",
        "--node-id",
        "32",
    ]);
    assert_eq!(ran.code, Some(0), "{ran:#?}");
    let build = read(&lexican, "folder/pump-2/build.rs");
    assert!(
        build.contains(".level(\"OBJ002\", lexican_codegen::Level::Warn)"),
        "{build}"
    );
    assert!(build.contains(".handle([0x2000])"), "{build}");
    let lib = read(&lexican, "folder/pump-2/src/lib.rs");
    assert!(lib.contains("NodeId::new(32)"), "{lib}");
    let test = read(&lexican, "folder/pump-2/tests/sdo.rs");
    assert!(test.contains("use pump_2::"), "{test}");
}

#[test]
fn what_is_there_is_not_touched() {
    let lexican = files();
    for name in ["folder", "taken"] {
        let ran = lexican.run(&["new", name, "--eds", "wdga.eds"]);
        let expected = format!("error: cannot make {name}: it is there already; take another name, or remove it\n");
        assert_eq!(ran.failed(), expected);
    }
    assert_eq!(names(lexican.path()), ["denied.eds", "folder/x", "taken", "wdga.eds"]);
}

#[test]
fn what_cannot_be_written_leaves_nothing() {
    let lexican = files();
    let nowhere = lexican.run(&["new", "nowhere/pump", "--eds", "wdga.eds"]);
    assert_eq!(
        nowhere.failed(),
        "error: cannot make nowhere/pump: there is no such file or directory\n"
    );
    let missing = lexican.run(&["new", "pump", "--eds", "missing.eds"]);
    assert_eq!(
        missing.failed(),
        "error: cannot read missing.eds: there is no such file or directory\n"
    );
    let checkout = lexican.run(&["new", "pump", "--eds", "wdga.eds", "--checkout", "folder"]);
    assert!(
        checkout.failed().contains("there is no runtime/Cargo.toml in it"),
        "{checkout:#?}"
    );
    let handle = lexican.run(&["new", "pump", "--eds", "wdga.eds", "--handle", "5FFF"]);
    assert!(
        handle.failed().starts_with("error: 5FFFh is not in wdga.eds"),
        "{handle:#?}"
    );
    let denied = lexican.run(&["new", "pump", "--eds", "denied.eds"]);
    assert_eq!((denied.code, denied.stdout.as_str()), (Some(1), ""));
    assert!(denied.stderr.contains("error[OBJ002]"), "{denied:#?}");
    assert_eq!(names(lexican.path()), ["denied.eds", "folder/x", "taken", "wdga.eds"]);
}

#[test]
fn a_name_that_cargo_would_refuse_is_refused_with_the_reason() {
    let lexican = files();
    let reason = |name: &str| -> Ran { lexican.run(&["new", name, "--eds", "wdga.eds"]) };
    for (name, why) in [
        ("2pump", "it does not start with a letter from a to z"),
        (".", "it does not start with a letter from a to z"),
        (
            "pump!",
            "it has something else in it than letters from a to z, digits, `-` and `_`",
        ),
        ("loop", "it is a keyword of Rust"),
        ("test", "Cargo or the crate itself has something else of this name"),
        (
            "lexican-runtime",
            "Cargo or the crate itself has something else of this name",
        ),
    ] {
        assert!(reason(name).failed().contains(why), "{name}");
    }
}

#[test]
fn a_file_from_standard_input_is_named_after_the_crate() {
    let lexican = files();
    let ran = lexican.run_with_input(&["new", "pump", "--eds", "-"], WDGA);
    assert_eq!(ran.code, Some(0), "{ran:#?}");
    assert!(read(&lexican, "pump/build.rs").contains("new(\"pump.eds\")"));
    assert_eq!(fs::read(lexican.path().join("pump/pump.eds")).unwrap(), WDGA);
}

/// Makes the crate, and runs its own tests, offline, with the versions of our lock file.
fn build(eds: &Path, name: &str, arguments: &[&str]) {
    // All are built in one folder, so that what they have in common is compiled once.
    static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());
    let _turn = ONE_AT_A_TIME.lock();
    let lexican = Lexican::with(&[]);
    let eds = eds.to_str().unwrap();
    let new = ["new", name, "--eds", eds, "--checkout", CHECKOUT];
    let ran = lexican.run(&[&new, arguments].concat());
    assert_eq!(ran.code, Some(0), "{ran:#?}");
    let folder = lexican.path().join(name);
    fs::copy(Path::new(CHECKOUT).join("Cargo.lock"), folder.join("Cargo.lock")).unwrap();
    cargo(&folder, &["test", "--quiet", "--offline"]);
    cargo(&folder, &["fmt", "--check"]);
    if has_minutes() {
        cargo(
            &folder,
            &[
                "clippy",
                "--quiet",
                "--offline",
                "--all-targets",
                "--",
                "-D",
                "warnings",
            ],
        );
    }
}

/// Whether there is time for more than one crate: `LEXICAN_NEW=1 cargo test -p lexican --test cli new`, a step of its own
/// in CI.
fn has_minutes() -> bool {
    env::var_os("LEXICAN_NEW").is_some()
}

#[track_caller]
fn cargo(folder: &Path, arguments: &[&str]) {
    let mut command = Command::new(env!("CARGO"));
    command.args(arguments).current_dir(folder);
    if arguments[0] != "fmt" {
        command.env("CARGO_TARGET_DIR", concat!(env!("CARGO_TARGET_TMPDIR"), "/new"));
    }
    let output = command.output().unwrap();
    let said = [output.stdout, output.stderr].concat();
    assert!(
        output.status.success(),
        "{arguments:?}\n{}",
        String::from_utf8_lossy(&said)
    );
}

#[test]
fn the_crate_of_the_wdga_builds_without_a_warning_and_passes_its_tests() {
    build(
        &Path::new(CHECKOUT).join("eds/devices/wdga.eds"),
        "wdga",
        &["--handle", "6003,6004,1010:1"],
    );
}

#[test]
fn the_crates_of_other_devices_build_and_pass_too() {
    if !has_minutes() {
        return notice("skipped: set LEXICAN_NEW to build the crates of more devices");
    }
    let devices = Path::new(CHECKOUT).join("eds/devices");
    build(&devices.join("wv58mr.dcf"), "wv58mr", &[]);
    build(&devices.join("cia406.eds"), "cia406", &["--node-id", "127"]);
    let corpus = Path::new(CHECKOUT).join("../shared/corpus/files");
    if !corpus.is_dir() {
        return notice("skipped: no corpus");
    }
    for (name, file) in [
        ("demo", "CANopenNode__CANopenDemo__demoDevice.eds"),
        ("drive", "KITmedical__kacanopen__402.eds"),
        ("pi-16", "HilscherAutomation__netPI-canopennode-npix-rcan__example.eds"),
    ] {
        build(&corpus.join(file), name, &[]);
    }
}

#[expect(clippy::print_stderr, reason = "a skipped test is to be seen")]
fn notice(text: &str) {
    eprintln!("{text}");
}
