//! docs/encoders.md names files and tests that there are.

use std::{
    fs,
    path::{Path, PathBuf},
};

/// Where the paths of a cell may start.
const ROOTS: [&str; 8] = [
    "",
    "encoders/wdga/src",
    "encoders/wv58mr/src",
    "eds/devices",
    "runtime/src",
    "tests/dialogues",
    "tests/tests",
    "tests/tests/wv58mr",
];

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The cells of all rows but the tables' heads, with the line that they are in.
fn rows(page: &str) -> Vec<(usize, Vec<String>)> {
    let lines = (1..).zip(page.lines());
    let rows = lines.filter(|(_, line)| line.starts_with("| ") && !line.starts_with("| chapter "));
    rows.map(|(number, line)| {
        let cells = line.trim_matches('|').split('|');
        (number, cells.map(|cell| cell.trim().to_owned()).collect())
    })
    .collect()
}

/// What stands between backticks.
fn code(cell: &str) -> impl Iterator<Item = &str> {
    cell.split('`').skip(1).step_by(2)
}

fn is_file(name: &str) -> bool {
    ROOTS.iter().any(|root| repository().join(root).join(name).exists())
}

/// All Rust text that may have tests in it.
fn sources(folder: &Path, text: &mut String) {
    let entries = fs::read_dir(folder).expect("a folder of the repository");
    for path in entries.map(|entry| entry.expect("an entry").path()) {
        if path.is_dir() {
            sources(&path, text);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            text.push_str(&fs::read_to_string(path).expect("Rust text"));
        }
    }
}

#[test]
fn every_row_names_files_and_tests_that_there_are() {
    let page = fs::read_to_string(repository().join("docs/encoders.md")).expect("the page");
    let mut code_of_all = String::new();
    for folder in ["tests/tests", "runtime/src", "encoders"] {
        sources(&repository().join(folder), &mut code_of_all);
    }
    let rows = rows(&page);
    assert!(!rows.is_empty());
    for (line, cells) in rows {
        let [chapter, statement, built, shown] = &cells[..] else {
            panic!("line {line} has not four cells");
        };
        assert!(
            !chapter.is_empty() && !statement.is_empty(),
            "line {line}: nothing is said"
        );
        assert!(
            !built.is_empty() || !shown.is_empty(),
            "line {line}: neither built nor shown"
        );
        // `sdo_*.rs` stands for many.
        for name in code(built).chain(code(shown)).filter(|name| !name.contains('*')) {
            let test = name.rsplit("::").next().unwrap_or(name);
            let is_there = is_file(name) || code_of_all.contains(&format!("fn {test}("));
            assert!(is_there, "line {line}: there is no `{name}`");
        }
    }
}
