//! What the rules say of the real files that lie beside the repository. They are the judges of false positives.

use std::{collections::BTreeMap, fmt::Write as _, fs, path::Path};

use lexican_eds::{
    Reading,
    diagnostic::Diagnostic,
    rules::{self, Levels, Rule},
};
use lexican_tests::corpus::{CorpusFile, corpus, notice};

fn check(file: CorpusFile) -> (Reading, Vec<Diagnostic>) {
    // The corpus puts where a file is from before its name: `owner__repository__name.eds`.
    let name = file.name.rsplit("__").next().unwrap_or(&file.name);
    let reading = lexican_eds::read(name, file.bytes);
    let found = rules::check(&reading, &Levels::default());
    (reading, found)
}

/// The counts stand in `eds/src/rules/real_files.tsv`, from where they go into docs/rules.md.
#[test]
fn each_rule_hits_as_many_real_files_as_was_looked_at() {
    let Some(files) = corpus("files") else { return };
    let number = files.len();
    let table = table(number, &hits(files));
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../eds/src/rules/real_files.tsv");
    let known = fs::read_to_string(&path).unwrap_or_default();
    if std::env::var_os("INSTA_UPDATE").is_some_and(|update| update == "always") && known != table {
        fs::write(&path, &table).unwrap();
        return;
    }
    let differences: Vec<&str> = table
        .lines()
        .filter(|line| !known.lines().any(|known| known == *line))
        .collect();
    assert!(
        known == table,
        "{} is stale: look at what is new, then write it by INSTA_UPDATE=always. Differences:\n{}",
        path.display(),
        differences.join("\n")
    );
}

/// In how many files each rule finds something, and how often.
fn hits(files: Vec<CorpusFile>) -> BTreeMap<&'static str, (usize, usize)> {
    let mut hits: BTreeMap<&'static str, (usize, usize)> = BTreeMap::new();
    for (_, found) in files.into_iter().map(check) {
        let mut codes: Vec<&'static str> = found.iter().map(|diagnostic| diagnostic.code.as_str()).collect();
        codes.sort_unstable();
        for same in codes.chunk_by(|one, other| one == other) {
            let (files, findings) = hits.entry(same[0]).or_default();
            *files += 1;
            *findings += same.len();
        }
    }
    hits
}

/// The table with the counts as they are, and the reasons as they were.
fn table(number: usize, hits: &BTreeMap<&'static str, (usize, usize)>) -> String {
    let mut table =
        format!("{number}\tfiles\tfindings\twhy the rule stands although it hits more than 5 % of the files\n");
    for rule in rules_about_files() {
        let code = rule.code().as_str();
        let (files, findings) = hits.get(code).copied().unwrap_or_default();
        let reason = rules::real_files()
            .find(|hits| hits.code == code)
            .map_or("", |hits| hits.reason);
        let _ = writeln!(table, "{}", format!("{code}\t{files}\t{findings}\t{reason}").trim_end());
    }
    table
}

fn rules_about_files() -> impl Iterator<Item = &'static Rule> {
    rules::all().iter().filter(|rule| rule.code().family() != "DMP")
}

#[test]
fn a_rule_that_hits_many_real_files_has_a_reason_to_stand_and_no_other_has() {
    for hits in rules::real_files() {
        let is_explained = hits.reason.ends_with('.');
        assert_eq!(
            is_explained,
            hits.are_many(),
            "{hits:?}: explain in real_files.tsv why it stands"
        );
    }
    // A new rule is counted where the files are.
    for hits in rules::real_files() {
        assert!(
            rules::find(hits.code).is_some(),
            "real_files.tsv counts {}, which is no rule",
            hits.code
        );
    }
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
        let stands = STANDS_FOR.iter().filter(|(code, _)| *code == diagnostic.code.as_str());
        stands.flat_map(move |(code, numbers)| {
            // PDO006 is one finding for all its places; the related place of another is the other half of the same.
            let others = diagnostic.related.iter().filter(move |_| *code == "PDO006");
            let spans = std::iter::once(diagnostic.span).chain(others.map(|related| related.span));
            spans.flat_map(move |span| {
                numbers
                    .iter()
                    .map(move |number| (source.line_column(span).line, *number))
            })
        })
    });
    let mut places: Vec<(u32, &str)> = places.collect();
    places.sort_unstable();
    places
}
