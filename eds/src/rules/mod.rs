//! What can be wrong with a file, one rule a file.
//!
//! [`check`] holds a [`Reading`] against all rules of the [registry](all), [`validate`] holds a device against its file by those
//! of family DMP. A rule's doc comment is its documentation for
//! users: `lexican explain CODE` prints it, `docs/rules.md` is made of it.
//!
//! # One more rule
//!
//! 1. A file in the folder of its family, named after what it finds, so that it reads well after "allow": copy a neighbour.
//! 2. A line in the family's `mod.rs`, and one in `registry.rs` with the next free code.
//! 3. `tests/fixtures/rules/CODE.eds`, which shows it and nothing else, and `CODE.fixed.eds`, which shows the cure.
//!    Of family DMP: `CODE.eds`, `CODE.json`, a dump which shows it, and `CODE.fixed.json`.
//!
//! `cargo test -p lexican-tests --test rules` then says what is still missing.

mod dmp;
mod ini;
mod levels;
mod manual;
mod quote;
mod registry;
mod report;
mod rule;

pub use levels::{LevelChange, LevelChangeError, Levels, UnknownRule};
pub use manual::{manual, page};
pub use registry::{Family, all, families, find};
pub use rule::Rule;

use crate::{
    Reading,
    diagnostic::{Diagnostic, Level},
    dump::Dump,
    ir::Dictionary,
};
pub(crate) use quote::{quoted, similar};
pub(crate) use report::Report;
pub(crate) use rule::{DocumentRule, DumpRule, declare_rule};

/// Everything that is wrong with a file, in the order of the file; at one place, in the order of the codes.
///
/// A rule at [`Level::Allow`] is not run.
#[must_use]
pub fn check(reading: &Reading, levels: &Levels) -> Vec<Diagnostic> {
    collect(levels, |rule, report| rule.check(reading, report))
}

/// Everything in which a device differs from its file, at the places of the file, ordered as by [`check`].
#[must_use]
pub fn validate(dictionary: &Dictionary, dump: &Dump, levels: &Levels) -> Vec<Diagnostic> {
    collect(levels, |rule, report| rule.validate(dictionary, dump, report))
}

fn collect(levels: &Levels, run: impl Fn(&Rule, &mut Report)) -> Vec<Diagnostic> {
    let rules = all().iter().map(|rule| (rule, levels.of(rule)));
    let heard = rules.filter(|(_, level)| *level > Level::Allow);
    let findings = heard.flat_map(|(rule, level)| {
        let mut report = Report::new(rule.facts, level);
        run(rule, &mut report);
        report.into_found()
    });
    let mut found: Vec<Diagnostic> = findings.collect();
    found.sort_by_key(|diagnostic| (diagnostic.span.start, diagnostic.code));
    found
}
