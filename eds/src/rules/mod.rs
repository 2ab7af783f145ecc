//! What can be wrong with a file, one rule a file.
//!
//! [`check`] holds a [`Reading`] against all rules of the [registry](all), [`validate`] holds a device against its file by
//! those of family DMP. A rule's doc comment is its documentation for users: `lexican explain CODE` prints it,
//! `docs/rules.md` is made of it.
//!
//! # One more rule
//!
//! 1. A file in the folder of its family, named after what it finds, so that it reads well after "allow": copy a neighbour.
//! 2. A line in the family's `mod.rs`, and one in `registry.rs` with the next free code.
//! 3. `tests/fixtures/rules/CODE.eds`, which shows it and nothing else, and `CODE.fixed.eds`, which shows the cure.
//!    Of family DMP: `CODE.eds`, `CODE.json`, a dump which shows it, and `CODE.fixed.json`.
//!
//! `cargo test -p lexican-tests --test rules` then says what is still missing.

mod allowance;
mod canchkeds;
mod catalogue;
mod com;
mod dcf;
mod dev;
mod dmp;
mod eds;
mod enc;
mod ini;
mod levels;
mod lex;
mod manual;
mod obj;
mod pdo;
mod quote;
mod real_files;
mod registry;
mod report;
mod rule;
mod unusual;

use allowance::Allowances;
pub use levels::{LevelChange, LevelChangeError, Levels, UnknownRule};
pub use manual::{anchor, manual, page};
pub use real_files::{Hits, number_of_real_files, real_files};
pub use registry::{Family, all, families, find};
pub use rule::{Fixable, Rule};

use crate::{
    Reading,
    diagnostic::{Diagnostic, Level},
    document::{Document, Problem},
    dump::Dump,
    ir::{Address, Dictionary, Value},
    span::Span,
};
pub(crate) use quote::{more, quoted, similar};
pub(crate) use report::Report;
pub(crate) use rule::{
    AllowanceRule, DictionaryRule, DocumentRule, DumpRule, EncoderRule, ModelRule, ReadingRule, declare_rule,
};
pub(crate) use unusual::{Unusual, certain_decimal, octal_cure, unusual, value_name};

/// Everything that is wrong with a file, in the order of the file; at one place, in the order of the codes.
///
/// A rule at [`Level::Allow`] is not run, nor is one about another device profile than 1000h names. What a comment in the file
/// allows, `; lexican: allow(OBJ003)`, is left out.
#[must_use]
pub fn check(reading: &Reading, levels: &Levels) -> Vec<Diagnostic> {
    check_as(reading, levels, profile(&reading.dictionary))
}

/// As [`check`], but the device is held against the rules of device profile `profile`, whatever its 1000h says: 406 stands for
/// encoders, 0 for none.
#[must_use]
pub fn check_as(reading: &Reading, levels: &Levels, profile: u16) -> Vec<Diagnostic> {
    let document = &reading.document;
    // Of a file that is something else it is enough to say so.
    let foreign = matches!(document.problems(), [Problem::NotCanopen { .. }, ..]);
    let text = document.source().text();
    let mut found = collect(text, levels, |rule, report| {
        if !foreign || rule.is_about_text() {
            rule.check(reading, profile, report);
        }
    });
    if !foreign {
        allow(document, levels, &mut found);
    }
    name_sections(document, &mut found);
    found
}

/// Takes away what comments in the file allow, and adds those comments that allow nothing.
fn allow(document: &Document, levels: &Levels, found: &mut Vec<Diagnostic>) {
    let mut allowances = Allowances::read(document);
    if allowances.is_empty() {
        return;
    }
    found.retain(|diagnostic| !allowances.cover(diagnostic));
    let idle = allowances.idle(levels);
    let mut about_comments = collect(document.source().text(), levels, |rule, report| {
        rule.check_allowances(&idle, report);
    });
    about_comments.retain(|diagnostic| !allowances.cover(diagnostic));
    found.append(&mut about_comments);
    sort(found);
}

/// The device profile that the low word of 1000h names (CiA 301, object 1000h); 0 for none, or when the file does not say.
#[must_use]
pub fn profile(dictionary: &Dictionary) -> u16 {
    match dictionary.entry(Address::new(0x1000, 0)).map(|entry| &entry.default) {
        #[expect(clippy::cast_possible_truncation, reason = "the profile is the low word")]
        Some(Some(Value::Unsigned(device_type))) => *device_type as u16,
        _ => 0,
    }
}

/// Everything in which a device differs from its file, at the places of the file, ordered as by [`check`].
#[must_use]
pub fn validate(reading: &Reading, dump: &Dump, levels: &Levels) -> Vec<Diagnostic> {
    let text = reading.document.source().text();
    let mut found = collect(text, levels, |rule, report| {
        rule.validate(&reading.dictionary, dump, report);
    });
    let mut allowances = Allowances::read(&reading.document);
    found.retain(|diagnostic| !allowances.cover(diagnostic));
    name_sections(&reading.document, &mut found);
    found
}

fn name_sections(document: &Document, found: &mut [Diagnostic]) {
    for diagnostic in found {
        diagnostic.section = section_before(document, diagnostic.span);
    }
}

/// The header of the section that `place` is in, unless it is the header itself or what is around it.
fn section_before(document: &Document, place: Span) -> Option<Span> {
    let sections = document.sections();
    let following = sections.partition_point(|section| section.header.start <= place.start);
    let header = sections.get(following.checked_sub(1)?)?.header;
    let lines = document.source();
    (lines.line_column(header).line != lines.line_column(place).line).then_some(header)
}

fn collect(text: &str, levels: &Levels, run: impl Fn(&Rule, &mut Report)) -> Vec<Diagnostic> {
    let rules = all().iter().map(|rule| (rule, levels.of(rule)));
    let heard = rules.filter(|(_, level)| *level > Level::Allow);
    let findings = heard.flat_map(|(rule, level)| {
        let mut report = Report::new(text, rule.facts, level);
        run(rule, &mut report);
        report.into_found()
    });
    let mut found: Vec<Diagnostic> = findings.collect();
    sort(&mut found);
    found
}

fn sort(found: &mut [Diagnostic]) {
    found.sort_by_key(|diagnostic| (diagnostic.span.start, diagnostic.code));
}
