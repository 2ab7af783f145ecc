//! python-canopen as a second opinion: it reads the real files, and every difference must be one that is known.
//!
//! `docs/oracle-python-canopen.md` lists the known differences by class, with the reason and the number of each. The
//! comparison itself is `tests/oracle/python_canopen.py`.

use std::fs;
use std::path::Path;
use std::process::Command;

use lexican_eds::document::Problem;
use lexican_eds::ir::{Dictionary, Entry, NodeId, Value};
use lexican_tests::corpus::{CorpusFile, corpus};
use lexican_tests::python;
use serde_json::{Value as Json, json};

/// The node-ID that `$NODEID` stands for in the comparison.
const NODE_ID: u8 = 1;

#[test]
fn python_canopen_reads_the_corpus_as_we_do_but_for_the_known_differences() {
    let Some(python) = python::with_canopen() else { return };
    let Some(files) = corpus("files") else { return };
    let readings: String = files.into_iter().filter_map(line).collect();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let input = Path::new(env!("CARGO_TARGET_TMPDIR")).join("python-canopen.jsonl");
    fs::write(&input, readings).unwrap();
    let output = Command::new(python)
        .arg(root.join("oracle/python_canopen.py"))
        .args([&input, &root.join("../docs/oracle-python-canopen.md")])
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    let failed = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}{failed}");
}

/// A file's path and its entries, on one line; `None` for a file that is no EDS.
fn line(file: CorpusFile) -> Option<String> {
    let reading = lexican_eds::read(file.name, file.bytes);
    let is_another_format = |problem: &Problem| matches!(problem, Problem::NotCanopen { .. });
    if reading.document.problems().iter().any(is_another_format) {
        return None;
    }
    let line = json!({"path": file.path, "entries": entries(&reading.dictionary)});
    Some(format!("{line}\n"))
}

fn entries(dictionary: &Dictionary) -> Vec<Json> {
    dictionary.entries().map(entry).collect()
}

fn entry(entry: &Entry) -> Json {
    json!({
        "index": entry.address.index,
        "sub": entry.address.sub,
        "data_type": entry.data_type.index(),
        "access": entry.access.name(),
        "pdo_mapping": entry.pdo_mapping,
        "configured": entry.configured,
        "default": entry.default.as_ref().map(|value| plain(value, entry)),
        "low": entry.low.as_ref().map(|value| plain(value, entry)),
        "high": entry.high.as_ref().map(|value| plain(value, entry)),
    })
}

/// A value as python-canopen holds it: numbers, text, bytes in hex.
fn plain(value: &Value, entry: &Entry) -> Json {
    match value {
        Value::Boolean(value) => json!(u8::from(*value)),
        Value::Integer(value) => json!(value),
        Value::Unsigned(value) => json!(value),
        Value::Real32(value) => json!(value),
        Value::Real64(value) => json!(value),
        Value::Text(text) => json!(text),
        Value::NodeIdPlus(_) | Value::Bytes(_) | Value::Time { .. } => {
            let bytes = value.to_bytes(entry.data_type, NodeId::new(NODE_ID));
            match value {
                Value::NodeIdPlus(_) => json!(little_endian(&bytes)),
                _ => json!({"bytes": bytes}),
            }
        }
    }
}

fn little_endian(bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .rev()
        .fold(0, |number, byte| number << 8 | u64::from(*byte))
}
