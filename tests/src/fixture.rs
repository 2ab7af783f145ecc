//! The fixtures of the rules.

use std::fs;
use std::path::{Path, PathBuf};

use lexican_eds::Reading;

/// Where the fixture called `name` is.
#[must_use]
pub fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/rules").join(name)
}

/// Reads the fixture called `stem`: a DCF, if there is one of that name, else an EDS.
///
/// # Panics
/// When there is neither.
#[must_use]
pub fn read(stem: &str) -> Reading {
    let names = ["dcf", "eds"].map(|extension| format!("{stem}.{extension}"));
    let there = names.into_iter().find(|name| path(name).exists());
    let name = there.unwrap_or_else(|| panic!("there is no fixture {stem}"));
    let bytes = fs::read(path(&name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    lexican_eds::read(name, bytes)
}
