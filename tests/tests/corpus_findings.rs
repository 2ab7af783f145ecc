//! What the rules say of the real files that lie beside the repository. They are the judges of false positives.

use std::{collections::BTreeMap, fmt::Write as _, fs, path::Path};

use lexican_eds::{
    Reading,
    diagnostic::Diagnostic,
    rules::{self, Levels},
};
use lexican_tests::corpus::{CorpusFile, corpus, notice};

fn check(file: CorpusFile) -> (Reading, Vec<Diagnostic>) {
    // The corpus puts where a file is from before its name: `owner__repository__name.eds`.
    let name = file.name.rsplit("__").next().unwrap_or(&file.name);
    let reading = lexican_eds::read(name, file.bytes);
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

/// What stands for the official checker's numbers: an object that is in a PDO is one finding here (PDO007), two there (W4, W5).
const STANDS_FOR: [(&str, &[&str]); 3] = [("EDS021", &["W21"]), ("PDO006", &["W4"]), ("PDO007", &["W4", "W5"])];

/// CiA's own checker finds 43 places in that file.
#[test]
fn the_official_checkers_places_are_found_and_no_others() {
    let oracle = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/oracle/demoDevice.canchkeds.tsv");
    let (Some(files), Ok(verdict)) = (corpus("files"), fs::read_to_string(&oracle)) else {
        notice(&format!("skipped: no verdict at {}", oracle.display()));
        return;
    };
    let lines = verdict.lines().skip(1).map(|line| line.split('\t').collect::<Vec<_>>());
    let mut expected: Vec<(u32, &str)> = lines.map(|columns| (columns[0].parse().unwrap(), columns[1])).collect();
    expected.sort_unstable();
    let file = files
        .into_iter()
        .find(|file| file.name == "CANopenNode__CANopenDemo__demoDevice.eds");
    let (reading, found) = check(file.unwrap());
    assert_eq!(expected.len(), 43);
    assert_eq!(places(&reading, &found), expected);
}

/// Line and the official checker's number of each finding that it would have as well.
fn places(reading: &Reading, found: &[Diagnostic]) -> Vec<(u32, &'static str)> {
    let source = reading.document.source();
    let places = found.iter().flat_map(|diagnostic| {
        let line = source.line_column(diagnostic.span).line;
        let stands = STANDS_FOR.iter().filter(|(code, _)| *code == diagnostic.code.as_str());
        stands.flat_map(move |(_, numbers)| numbers.iter().map(move |number| (line, *number)))
    });
    let mut places: Vec<(u32, &str)> = places.collect();
    places.sort_unstable();
    places
}
