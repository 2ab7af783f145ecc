//! What `lexican format` promises, held against the rules' fixtures and the real files.

use std::{collections::BTreeMap, fs, path::Path, sync::LazyLock};

use lexican_eds::{
    Reading,
    diagnostic::{Diagnostic, Level},
    diff, format,
    rules::{self, Levels},
};
use lexican_tests::corpus::corpus;

/// A file and its canonical form.
struct Case {
    name: String,
    before: Reading,
    after: Reading,
}

/// The fixtures, and the real files where they are.
fn cases() -> &'static [Case] {
    static CASES: LazyLock<Vec<Case>> = LazyLock::new(|| {
        let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/rules");
        let fixtures = fs::read_dir(fixtures).into_iter().flatten().flatten();
        let fixtures = fixtures.filter(|file| file.path().extension().is_some_and(|extension| extension == "eds"));
        let fixtures = fixtures.map(|file| {
            (
                file.file_name().to_string_lossy().into_owned(),
                fs::read(file.path()).unwrap_or_default(),
            )
        });
        let real = corpus("files")
            .into_iter()
            .flatten()
            .map(|file| (file.name, file.bytes));
        fixtures.chain(real).map(|(name, bytes)| case(name, bytes)).collect()
    });
    &CASES
}

fn case(name: String, bytes: Vec<u8>) -> Case {
    let before = lexican_eds::read(name.as_str(), bytes);
    let after = format::format(before.clone()).unwrap_or_else(|error| panic!("{name}: {error}"));
    Case { name, before, after }
}

fn format(text: &str) -> String {
    let formatted = format::format(lexican_eds::read("pump.eds", text.into()));
    formatted.map_or_else(
        |error| error.to_string(),
        |reading| reading.document.source().text().to_owned(),
    )
}

#[test]
fn sections_keywords_and_numbers_come_into_the_standards_order_and_form() {
    let text = "\
; made by hand

[2000]
DATATYPE = 0x7
ParameterName=Speed ; fast
DefaultValue=0Xab
; the first list
[OptionalObjects]
2=0x1018
1 = 4119
SupportedObjects=1
[1018sub0]
DefaultValue=1
[1018]
SubNumber=7
; behind 1018

[FileInfo]
FileName=pump.eds
";
    let canonical = "\
; made by hand

[FileInfo]
FileName=pump.eds

; the first list
[OptionalObjects]
SupportedObjects=2
1=0x1017
2=0x1018

[1018]
SubNumber=1
; behind 1018

[1018sub0]
DefaultValue=1

[2000]
ParameterName=Speed ; fast
DataType=0x0007
DefaultValue=0xAB
";
    assert_eq!(format(text), canonical);
    assert_eq!(format(canonical), canonical);
}

#[test]
fn junk_stays_behind_its_line_and_unknown_sections_come_last_as_they_are() {
    let text = "[Vendor]\nb = 1\na = 2\n[FileInfo]\nDescription=a pump\nof stainless steel\nFileName=pump.eds\n";
    let canonical = "[FileInfo]\nFileName=pump.eds\nDescription=a pump\nof stainless steel\n\n[Vendor]\nb=1\na=2\n";
    assert_eq!(format(text), canonical);
}

#[test]
fn what_stands_twice_keeps_its_order() {
    let text = "[1017]\nDefaultValue=2\nDataType=0x0006\nDefaultValue=1\n[1000]\n[1017]\nDataType=0x0005\n";
    let canonical = "[1000]\n\n[1017]\nDataType=0x0006\nDefaultValue=2\nDefaultValue=1\n\n[1017]\nDataType=0x0005\n";
    assert_eq!(format(text), canonical);
}

#[test]
fn the_canonical_form_is_its_own_canonical_form() {
    for case in cases() {
        let bytes = case.after.document.to_bytes();
        let again = format::format(lexican_eds::read(case.name.as_str(), bytes.clone())).unwrap();
        assert!(again.document.to_bytes() == bytes, "{}", case.name);
    }
}

#[test]
fn the_device_stays_the_same() {
    for case in cases() {
        let found = diff::compare(&case.before.dictionary, &case.after.dictionary);
        assert_eq!(found, [], "{}", case.name);
    }
}

#[test]
fn no_comment_and_no_text_is_lost() {
    for case in cases() {
        let comments = |reading: &Reading| {
            let source = reading.document.source();
            let lines = (1..=source.line_count()).map(|line| source.line_text(line).trim().to_owned());
            let mut comments: Vec<String> = lines.filter(|line| line.starts_with(';')).collect();
            comments.sort();
            comments
        };
        let (before, after) = (comments(&case.before), comments(&case.after));
        let mut missing = before.iter().filter(|comment| after.binary_search(comment).is_err());
        assert_eq!(missing.next(), None, "{}", case.name);
        assert!(after.len() >= before.len(), "{}", case.name);
    }
}

#[test]
fn the_canonical_form_has_no_new_findings() {
    let grave = |reading: &Reading| {
        let found = rules::check(reading, &Levels::default());
        let mut counts = BTreeMap::<&str, usize>::new();
        for diagnostic in found
            .iter()
            .filter(|diagnostic: &&Diagnostic| diagnostic.level > Level::Note)
        {
            *counts.entry(diagnostic.code.as_str()).or_default() += 1;
        }
        counts
    };
    for case in cases() {
        let before = grave(&case.before);
        for (code, number) in grave(&case.after) {
            let known = before.get(code).copied().unwrap_or_default();
            assert!(number <= known, "{}: {number} of {code}, {known} before", case.name);
        }
    }
}
