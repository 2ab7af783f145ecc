//! What can be wrong with a file, one rule a file.
//!
//! [`check`] holds a [`Reading`] against all rules of the [registry](all). A rule's doc comment is its documentation for
//! users: `lexican explain CODE` prints it, `docs/rules.md` is made of it.
//!
//! # One more rule
//!
//! 1. A file in the folder of its family, named after what it finds, so that it reads well after "allow": copy a neighbour.
//! 2. A line in the family's `mod.rs`, and one in `registry.rs` with the next free code.
//! 3. `tests/fixtures/rules/CODE.eds`, which shows it and nothing else, and `CODE.fixed.eds`, which shows the cure.
//!
//! `cargo test -p lexican-tests --test rules` then says what is still missing.

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
};
pub(crate) use quote::{quoted, similar};
pub(crate) use report::Report;
pub(crate) use rule::{DocumentRule, declare_rule};

/// Everything that is wrong with a file, in the order of the file; at one place, in the order of the codes.
///
/// A rule at [`Level::Allow`] is not run.
#[must_use]
pub fn check(reading: &Reading, levels: &Levels) -> Vec<Diagnostic> {
    let rules = all().iter().map(|rule| (rule, levels.of(rule)));
    let heard = rules.filter(|(_, level)| *level > Level::Allow);
    let mut found: Vec<Diagnostic> = heard.flat_map(|(rule, level)| findings(rule, level, reading)).collect();
    found.sort_by_key(|diagnostic| (diagnostic.span.start, diagnostic.code));
    found
}

fn findings(rule: &Rule, level: Level, reading: &Reading) -> Vec<Diagnostic> {
    let mut report = Report::new(rule.facts, level);
    rule.run(reading, &mut report);
    report.into_found()
}
