//! A device that python-canopen makes of our files, dumped by the script of docs/dump-format.md: nothing of ours has touched
//! the dump before it is validated.

use std::{fs, path::Path, process::Command};

use lexican_eds::{
    dump::Dump,
    rules::{self, Levels},
};
use lexican_tests::python;

/// The dump that python-canopen takes of its own device.
fn dump(python: &str, file: &str) -> Dump {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let scratch = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let (script, out) = (scratch.join(format!("{file}.py")), scratch.join(format!("{file}.json")));
    fs::write(&script, documented_script()).expect("a folder for tests");
    let output = Command::new(python)
        .arg(root.join("oracle/dump_local_node.py"))
        .args([&script, &root.join("../eds/devices").join(file), &out])
        .output()
        .expect("python runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = fs::read(&out).expect("the dump");
    Dump::from_json(&text).unwrap_or_else(|error| panic!("{}:{error}", out.display()))
}

fn documented_script() -> &'static str {
    let page = include_str!("../../docs/dump-format.md");
    let (_, rest) = page.split_once("```python\n").expect("a script");
    rest.split_once("```").expect("its end").0
}

/// It has no value where the file gives no default, and says so with an abort code.
#[test]
fn a_device_of_python_canopen_differs_from_its_file_only_where_the_file_gives_no_value() {
    let Some(python) = python::with_canopen() else { return };
    for file in ["wdga.eds", "wv58mr.eds", "cia406.eds"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../eds/devices").join(file);
        let reading = lexican_eds::read(file, fs::read(path).expect("one of our files"));
        let found = rules::validate(&reading, &dump(&python, file), &Levels::default());
        let places: Vec<_> = found
            .iter()
            .map(|diagnostic| (diagnostic.code.as_str(), diagnostic.span))
            .collect();
        let open = reading
            .dictionary
            .entries()
            .filter(|entry| entry.default.is_none() && entry.access.readable());
        let mut expected: Vec<_> = open.map(|entry| ("DMP013", entry.spans.section)).collect();
        expected.sort_by_key(|(_, span)| span.start);
        assert_eq!(places, expected, "{file}: {found:#?}");
    }
}
