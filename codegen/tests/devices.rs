//! The code of each device and fixture is the file that `lexican-tests` compiles: what is reviewed is what runs.
//!
//! After a wanted change: `INSTA_UPDATE=always cargo test -p lexican-codegen --test devices`, and read the difference.

use std::{fs, path::Path};

use lexican_codegen::{Builder, Selector};

/// Compiles `path`, relative to the repository's root, as `builder` is set up, and holds it against
/// `tests/generated/<name>.snap.rs`.
fn check(path: &str, set_up: impl FnOnce(Builder) -> Builder) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let generated = set_up(Builder::new(root.join(path)))
        .generate()
        .expect("the file is compiled");
    let snapshots = root.join("tests/generated");
    let reviewed = fs::read_to_string(snapshots.join(generated.name()).with_extension("snap.rs"));
    show_difference(&reviewed.unwrap_or_default(), generated.source());
    insta::with_settings!({ snapshot_path => snapshots, prepend_module_to_snapshot => false, omit_expression => true }, {
        let name = format!("{}.rs", generated.name());
        insta::assert_binary_snapshot!(&name, generated.source().as_bytes().to_vec());
    });
}

#[expect(
    clippy::print_stdout,
    reason = "insta says of a binary snapshot only that it differs; this says what first"
)]
fn show_difference(reviewed: &str, source: &str) {
    let mut lines = reviewed.lines().zip(source.lines()).enumerate();
    if let Some((at, (old, new))) = lines.find(|(_, (old, new))| old != new) {
        println!("line {}:\n- {old}\n+ {new}", at + 1);
    }
}

#[test]
fn multiplexed() {
    check("tests/fixtures/codegen/multiplexed.eds", |builder| builder);
}

#[test]
fn servers() {
    check("tests/fixtures/codegen/servers.eds", |builder| builder);
}

#[test]
fn wdga() {
    check("eds/devices/wdga.eds", |builder| builder);
}

#[test]
fn wdga_singleturn() {
    check("eds/devices/wdga-st.eds", |builder| builder);
}

#[test]
fn wdga_configured() {
    check("eds/devices/wdga.dcf", |builder| builder.module_name("wdga_configured"));
}

#[test]
fn wv58mr() {
    check("eds/devices/wv58mr.eds", |builder| builder);
}

#[test]
fn wv58mr_singleturn() {
    check("eds/devices/wv58mr-st.eds", |builder| builder);
}

#[test]
fn wv58mr_configured() {
    check("eds/devices/wv58mr.dcf", |builder| {
        builder.module_name("wv58mr_configured")
    });
}

#[test]
fn cia406() {
    check("eds/devices/cia406.eds", |builder| builder);
}

#[test]
fn cia406_of_many_channels() {
    check("eds/devices/cia406-multi.eds", |builder| builder);
}

#[test]
fn handlers_beyond_one_function() {
    check("eds/devices/wv58mr.eds", |builder| {
        builder
            .module_name("wv58mr_handled")
            .handle_writes([
                0x1005, 0x100C, 0x100D, 0x1014, 0x1017, 0x1800, 0x1801, 0x2001, 0x2003, 0x2004,
            ])
            .handle_writes([0x6000, 0x6001, 0x6002, 0x6003, 0x6031, 0x6200])
    });
}

#[test]
fn every_kind_of_object() {
    check("tests/fixtures/codegen/every_kind.eds", |builder| {
        builder
            .handle([0x2600, 0x2601, 0x2602, 0x2603, 0x2604, 0x2605, 0x2606, 0x6004, 0x6030])
            .handle_writes([(0x2300, 1), (0x2300, 3)])
            .handle_writes([Selector::Object(0x1010), Selector::Value(0x6003, 0)])
            .stream([0x2607])
            .capacity(0x2009 + 10, 20)
            .capacity((0x2603, 0), 100)
    });
}
