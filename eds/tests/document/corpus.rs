//! The real files, whole.

use lexican_eds::document::{Document, Format, Problem};
use lexican_eds::source::{Encoding, Source};

use crate::files::{corpus, real_eds, real_files};

#[test]
fn every_real_file_is_written_back_byte_by_byte() {
    for file in real_files().iter().chain(&corpus("not-canopen")) {
        assert!(file.document.to_bytes() == file.bytes, "{}", file.name);
    }
}

#[test]
fn sections_and_pairs_are_those_that_a_plain_reading_finds() {
    for file in real_eds() {
        assert_eq!(
            read(&file.document),
            plainly_read(file.document.source()),
            "{}",
            file.name
        );
    }
}

type Sections<'a> = Vec<(&'a str, Vec<(&'a str, &'a str)>)>;

fn read(document: &Document) -> Sections<'_> {
    let text = |span| document.text(span);
    let pairs = |entries: &[_]| {
        let entries = entries.iter();
        entries
            .map(|entry: &lexican_eds::document::Entry| (text(entry.key), text(entry.value)))
            .collect()
    };
    let sections = document.sections().iter();
    sections
        .map(|section| (text(section.label), pairs(&section.entries)))
        .collect()
}

/// An INI reader of ten lines, for files that need no more.
fn plainly_read(source: &Source) -> Sections<'_> {
    let mut sections = Sections::new();
    let is_blank = |character: char| character.is_whitespace() || character == '\x1A';
    for line in source.text().split(['\r', '\n']) {
        let line = line.trim_matches(is_blank);
        if line.starts_with([';', '#']) {
            continue;
        }
        if let Some((label, _)) = line.strip_prefix('[').and_then(|line| line.split_once(']')) {
            sections.push((label.trim(), Vec::new()));
        } else if let Some((key, value)) = line.split_once('=') {
            let (_, pairs) = sections.last_mut().unwrap();
            pairs.push((key.trim(), value.trim()));
        }
    }
    sections
}

#[test]
fn files_of_another_format_give_one_problem_that_says_which() {
    for file in real_files().iter().filter(|file| !file.is_ini()) {
        assert_eq!(
            foreign_format(&file.document),
            Some(Format::CanopenXml),
            "{}",
            file.name
        );
    }
    let others = corpus("not-canopen");
    let formats: Vec<_> = others
        .iter()
        .map(|file| foreign_format(&file.document).unwrap())
        .collect();
    if !formats.is_empty() {
        let odva = Format::Odva;
        assert_eq!(formats, [Format::PowerlinkXml, odva, odva, odva, odva, odva]);
    }
}

/// What a file without sections is, if that is the only problem.
fn foreign_format(document: &Document) -> Option<Format> {
    match document.problems() {
        [Problem::NotCanopen { what, .. }] if document.sections().is_empty() => Some(*what),
        _ => None,
    }
}

#[test]
fn no_real_eds_is_taken_for_something_else() {
    for file in real_eds() {
        assert!(!file.document.sections().is_empty(), "{}", file.name);
        let junk = |problem: &&Problem| {
            matches!(
                problem,
                Problem::NotCanopen { .. } | Problem::JunkLine { .. } | Problem::MalformedHeader { .. }
            )
        };
        assert_eq!(file.document.problems().iter().find(junk), None, "{}", file.name);
    }
}

#[test]
fn names_in_real_files_are_spelled_as_their_owners_spell_them() {
    let mut words = vec![
        ("Schönaich", Encoding::Cp850),
        ("Nykänen", Encoding::Windows1252),
        ("Törnqvist", Encoding::Windows1252),
        ("TEMP [°C]", Encoding::Windows1252),
        ("cos φ", Encoding::Utf8),
    ];
    for file in real_files() {
        let source = file.document.source();
        for line in 1..=source.line_count() {
            let text = source.line_text(line);
            if text.is_ascii() {
                continue;
            }
            words.retain(|(word, encoding)| !(text.contains(word) && source.encoding(line) == *encoding));
            let other_readings = ["Sch”naich", "Nykõnen", "T÷rnqvist", "[░C]"];
            assert!(!other_readings.iter().any(|word| text.contains(word)), "{text}");
        }
    }
    assert!(
        words.is_empty() || real_files().is_empty(),
        "{words:?} do not stand in any file"
    );
}
