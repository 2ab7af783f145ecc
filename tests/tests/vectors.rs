//! The shared vectors: dialogues recorded from other stacks' tests, or written by hand from CiA 301.
//!
//! A vector that needs a service of a later issue is skipped by name; the count is printed.

use std::path::Path;

use lexican_runtime::od::{Access, DataType};
use lexican_runtime::{Address, CanId, Frame};
use lexican_tests::{
    bus::Bus,
    line,
    simulated::{Object, Simulated},
};
use serde_json::Value;

fn vectors() -> Option<Vec<Value>> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/vectors/vectors.json");
    let text = std::fs::read_to_string(&file).ok()?;
    let all: Value = serde_json::from_str(&text).expect("vectors.json is JSON");
    all["vectors"].as_array().cloned()
}
