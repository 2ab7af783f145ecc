//! How many real files each rule hits, as last counted: the judges of false positives.
//!
//! `real_files.tsv` beside this file is written by the test `corpus_findings`, where the files are; why a rule that hits many
//! of them stands is written by hand in its last column.

use std::fmt::Write as _;

use super::{Rule, anchor, find};

const TABLE: &str = include_str!("real_files.tsv");

/// What a rule found in the real files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hits {
    /// The rule's code.
    pub code: &'static str,
    /// In how many files it found something.
    pub files: u32,
    /// How often it did.
    pub findings: u32,
    /// Why the rule stands although it hits so many; empty when it hits few.
    pub reason: &'static str,
}

impl Hits {
    /// Whether these are so many that the rule needs a reason: more than 5 % of the files.
    #[must_use]
    pub fn are_many(&self) -> bool {
        self.files * 20 > number_of_real_files()
    }
}

/// How many files were looked at.
#[must_use]
pub fn number_of_real_files() -> u32 {
    let first = TABLE.lines().next().and_then(|line| line.split('\t').next());
    first.and_then(|number| number.parse().ok()).unwrap_or_default()
}

/// What each rule found, in the order of the codes; a rule about dumps is not among them.
pub fn real_files() -> impl Iterator<Item = Hits> {
    TABLE.lines().skip(1).filter_map(|line| {
        let mut columns = line.split('\t');
        Some(Hits {
            code: columns.next()?,
            files: columns.next()?.parse().ok()?,
            findings: columns.next()?.parse().ok()?,
            reason: columns.next().unwrap_or_default(),
        })
    })
}

/// In how many files `rule` found something, for a table; a rule about dumps has no number.
pub(super) fn files(rule: &Rule) -> String {
    let hits = real_files().find(|hits| hits.code == rule.code().as_str());
    hits.map_or_else(String::new, |hits| hits.files.to_string())
}

/// The rules that hit many files, each with the reason why it stands, in Markdown.
pub(super) fn section() -> String {
    let mut text = INTRODUCTION.replace("NUMBER", &number_of_real_files().to_string());
    for hits in real_files().filter(Hits::are_many) {
        let Some(rule) = find(hits.code) else { continue };
        let Hits {
            code,
            files,
            findings,
            reason,
        } = hits;
        let (anchor, name) = (anchor(rule), rule.name());
        let _ = writeln!(text, "| [{code}](#{anchor}) {name} | {files} | {findings} | {reason} |");
    }
    text
}

const INTRODUCTION: &str = "
## What real files say

The column *files* above counts in how many of NUMBER real EDS and DCF files, those of vendors, stacks and hobbyists found in public
repositories, the rule finds something. A test counts again. Each rule that hits more than one file of twenty was looked at for
false alarms; why it stands all the same:

| rule | files | findings | why it stands |
|---|---|---|---|
";
