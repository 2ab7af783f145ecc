//! Code is generated for the real files, and compiles: all of it in one crate, with every warning denied.
//!
//! Compiling takes minutes, so it is a step of its own in CI: `LEXICAN_COMPILE_CORPUS=1 cargo test -p lexican-tests --test
//! corpus_compiles`.

use std::{
    env,
    fmt::Write as _,
    fs,
    path::{Path, PathBuf},
    process::Command,
};

use lexican_codegen::{Builder, Error, Generated, Level};
use lexican_eds::rules;
use lexican_tests::corpus::{CorpusFile, corpus, notice};

/// The files that are meant to be an EDS or DCF.
fn files() -> Option<Vec<CorpusFile>> {
    Some(corpus("files")?.into_iter().filter(|file| !file.is_xml()).collect())
}

fn builder(number: usize, file: &CorpusFile) -> Builder {
    Builder::from_bytes(&*file.name, &*file.bytes).module_name(format!("file_{number}"))
}

/// The code, whatever the rules say: it is to compile even so.
fn unchecked(number: usize, file: &CorpusFile) -> Generated {
    let families = rules::families().iter().map(|family| family.letters);
    let builder = families.fold(builder(number, file), |builder, letters| {
        builder.level(letters, Level::Allow)
    });
    builder
        .generate()
        .unwrap_or_else(|error| panic!("{}: {error}", file.name))
}

/// The diagnostics that refuse a file: the first line of each.
fn refusal(file: &CorpusFile, error: &Error) -> String {
    let Error::Refused { diagnostics, .. } = error else {
        panic!("{}: {error}", file.name);
    };
    let firsts = diagnostics.iter().filter_map(|diagnostic| diagnostic.lines().next());
    let mut lines: Vec<&str> = firsts.take(3).collect();
    let more = format!("and {} more", diagnostics.len() - lines.len());
    if diagnostics.len() > lines.len() {
        lines.push(&more);
    }
    lines.join("\n")
}

#[test]
fn only_what_a_rule_denies_is_refused() {
    let Some(files) = files() else { return };
    let outcomes = files
        .iter()
        .enumerate()
        .map(|(number, file)| (file, builder(number, file).generate()));
    let refusals = outcomes.filter_map(|(file, outcome)| Some(refusal(file, &outcome.err()?)));
    let refusals: Vec<String> = refusals.collect();
    let (refused, all) = (refusals.len(), files.len());
    insta::assert_snapshot!(format!(
        "{refused} of {all} files are refused\n\n{}",
        refusals.join("\n\n")
    ));
}

#[test]
fn the_code_of_every_file_compiles_without_a_warning() {
    if env::var_os("LEXICAN_COMPILE_CORPUS").is_none() {
        return notice("skipped: set LEXICAN_COMPILE_CORPUS to compile the code of the whole corpus");
    }
    let Some(files) = files() else { return };
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("corpus_compiles");
    write_crate(&folder, &files);
    let status = Command::new(env!("CARGO"))
        .args(["clippy", "--quiet", "--offline", "--manifest-path"])
        .arg(folder.join("Cargo.toml"))
        .arg("--target-dir")
        .arg(folder.join("target"))
        .env("CARGO_INCREMENTAL", "0")
        .status();
    assert!(
        status.expect("cargo runs").success(),
        "see the compiler's messages above"
    );
}

/// A crate of the code of all `files`, a module each.
fn write_crate(folder: &Path, files: &[CorpusFile]) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut lib = String::from("//! The code of the whole corpus.\n#![no_std]\n");
    for (number, file) in files.iter().enumerate() {
        let _ = write!(lib, "\n// {}\n{}", file.name, unchecked(number, file).source());
    }
    let runtime = root.join("runtime").canonicalize().expect("the runtime's folder");
    fs::create_dir_all(folder.join("src")).expect("a folder for the crate");
    fs::write(folder.join("src/lib.rs"), lib).expect("the crate's source is written");
    fs::write(folder.join("Cargo.toml"), manifest(&runtime)).expect("the crate's manifest is written");
    fs::copy(root.join("Cargo.lock"), folder.join("Cargo.lock")).expect("the same versions as in the workspace");
}

fn manifest(runtime: &Path) -> String {
    let runtime = runtime.display();
    format!(
        "[package]
name = \"corpus\"
version = \"0.0.0\"
edition = \"2021\"
rust-version = \"1.77\"

[dependencies]
lexican-runtime = {{ path = '{runtime}' }}

[lints.rust]
warnings = \"deny\"
missing_docs = \"deny\"
unsafe_code = \"forbid\"
keyword_idents_2024 = \"deny\"

[lints.clippy]
pedantic = {{ level = \"deny\", priority = -1 }}
# Some files have strings of many kilobytes, and thousands of objects.
large_const_arrays = \"allow\"
large_stack_arrays = \"allow\"

[workspace]
"
    )
}
