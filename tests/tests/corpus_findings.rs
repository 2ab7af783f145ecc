//! What the rules say of the real files that lie beside the repository. They are the judges of false positives.

use std::{collections::BTreeMap, fmt::Write as _, fs, path::Path};

use lexican_eds::{
    Reading,
    diagnostic::Diagnostic,
    rules::{self, Levels},
};
use lexican_tests::corpus::{CorpusFile, corpus};

fn check(file: CorpusFile) -> (Reading, Vec<Diagnostic>) {
    let reading = lexican_eds::read(file.name, file.bytes);
    let found = rules::check(&reading, &Levels::default());
    (reading, found)
}

#[test]
fn each_rule_hits_as_many_real_files_as_was_looked_at() {
    let Some(files) = corpus("files") else { return };
    let number = files.len();
    let mut hits: BTreeMap<&str, (usize, usize)> = BTreeMap::new();
    for (_, found) in files.into_iter().map(check) {
        let mut codes: Vec<&str> = found.iter().map(|diagnostic| diagnostic.code.as_str()).collect();
        codes.sort_unstable();
        for same in codes.chunk_by(|one, other| one == other) {
            let (files, findings) = hits.entry(same[0]).or_default();
            *files += 1;
            *findings += same.len();
        }
    }
    let mut table = format!("of {number} files\n\nrule    level  files  findings\n");
    for rule in rules::all().iter().filter(|rule| rule.code().family() != "DMP") {
        let (files, findings) = hits.get(rule.code().as_str()).copied().unwrap_or_default();
        let _ = writeln!(
            table,
            "{}  {:<5}  {files:>5}  {findings:>8}  {}",
            rule.code(),
            rule.level(),
            rule.name()
        );
    }
    insta::assert_snapshot!(table);
}

#[test]
fn a_file_of_another_format_has_one_finding_that_says_what_it_is() {
    let (Some(files), Some(others)) = (corpus("files"), corpus("not-canopen")) else {
        return;
    };
    let files = files.into_iter().filter(CorpusFile::is_xml).chain(others);
    for (reading, found) in files.map(check) {
        let codes: Vec<&str> = found.iter().map(|diagnostic| diagnostic.code.as_str()).collect();
        assert_eq!(codes, ["INI014"], "{}", reading.document.source().name());
    }
}

/// CiA's own checker says W21 of that line; we say EDS021.
#[test]
fn the_official_checkers_unknown_keyword_is_found_at_its_line() {
    let oracle = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/oracle/demoDevice.canchkeds.tsv");
    let (Some(files), Ok(verdict)) = (corpus("files"), fs::read_to_string(oracle)) else {
        return;
    };
    let unknown = verdict.lines().map(|line| line.split('\t').collect::<Vec<_>>());
    let unknown = unknown.filter(|columns| columns.get(1) == Some(&"W21"));
    let expected: Vec<u32> = unknown.map(|columns| columns[0].parse().unwrap()).collect();
    let file = "CANopenNode__CANopenDemo__demoDevice.eds";
    let file = files.into_iter().find(|other| other.name == file);
    let (reading, found) = check(file.unwrap());
    let ours = found.iter().filter(|diagnostic| diagnostic.code.as_str() == "EDS021");
    let lines = ours.map(|diagnostic| reading.document.source().line_column(diagnostic.span).line);
    assert_eq!(lines.collect::<Vec<_>>(), expected);
}
