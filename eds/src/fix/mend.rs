//! Check, fix, and again, until nothing is left to fix.

use std::collections::BTreeMap;

use super::{Fix, plan::Plan};
use crate::{
    Reading,
    diagnostic::{Code, Diagnostic},
};

/// A fix may wait for another that changes the same text, or make way for one: what a value's hex digits are is seen when
/// the comment behind it is gone. No value waits for as many as this.
const MOST_PASSES: usize = 16;

/// A file with its safe cures made.
#[derive(Clone, Debug)]
pub struct Mended {
    /// The file as it is now.
    pub reading: Reading,
    /// What is still to be found in it.
    pub remaining: Vec<Diagnostic>,
    /// How many findings of each rule were fixed.
    pub fixed: BTreeMap<Code, usize>,
}

/// Makes the fixes of all that `check` finds, until it finds nothing that has one.
///
/// ```
/// use lexican_eds::{fix, rules::{self, Levels}};
///
/// let file = "[OptionalObjects]\r\nSupportedObjects = 1\r\n1 = 0x1008\r\n3 = 0x1017 ; heartbeat\r\n";
/// let reading = lexican_eds::read("pump.eds", file.into());
/// let mended = fix::mend(reading, |reading| rules::check(reading, &Levels::default()));
///
/// let fixed = "[OptionalObjects]\r\nSupportedObjects = 2\r\n1 = 0x1008\r\n; heartbeat\r\n2 = 0x1017\r\n";
/// assert_eq!(mended.reading.document.to_bytes(), fixed.as_bytes());
/// ```
#[must_use]
pub fn mend(mut reading: Reading, check: impl Fn(&Reading) -> Vec<Diagnostic>) -> Mended {
    let mut remaining = check(&reading);
    let mut fixed = BTreeMap::new();
    for _ in 0..MOST_PASSES {
        let Some(next) = pass(&reading, &remaining) else { break };
        let found = check(&next);
        count(&remaining, &found, &mut fixed);
        (reading, remaining) = (next, found);
    }
    Mended {
        reading,
        remaining,
        fixed,
    }
}

/// The file with the fixes of `found` made that go together; `None` when that changes nothing.
fn pass(reading: &Reading, found: &[Diagnostic]) -> Option<Reading> {
    let fixes = found.iter().filter_map(|diagnostic| diagnostic.fix.as_ref());
    let all = made(reading, fixes.clone());
    // One that a line's encoding cannot hold shall not keep the others from being made.
    all.or_else(|| {
        let mut singly = fixes.take(MOST_PASSES).map(std::iter::once);
        singly.find_map(|fix| made(reading, fix))
    })
}

fn made<'f>(reading: &Reading, fixes: impl Iterator<Item = &'f Fix> + Clone) -> Option<Reading> {
    let document = &reading.document;
    let edit = Plan::of(document, fixes).ok()?;
    let edited = edit.apply().ok()?;
    (edited.to_bytes() != document.to_bytes()).then(|| crate::read_document(edited))
}

/// Counts what is no longer found.
fn count(before: &[Diagnostic], after: &[Diagnostic], fixed: &mut BTreeMap<Code, usize>) {
    let fixable = |found: &[Diagnostic]| {
        let mut counts = BTreeMap::<Code, usize>::new();
        for diagnostic in found.iter().filter(|diagnostic| diagnostic.fix.is_some()) {
            *counts.entry(diagnostic.code).or_default() += 1;
        }
        counts
    };
    let after = fixable(after);
    for (code, number) in fixable(before) {
        let gone = number.saturating_sub(after.get(&code).copied().unwrap_or_default());
        if gone > 0 {
            *fixed.entry(code).or_default() += gone;
        }
    }
}
