//! How many findings there are at each level.

use std::{fmt, ops::AddAssign};

use lexican_eds::{
    diagnostic::{Diagnostic, Level},
    render,
};
use serde::Serialize;

#[derive(Clone, Copy, Debug, Default, Serialize)]
pub(crate) struct Counts {
    pub(crate) deny: usize,
    pub(crate) warn: usize,
    pub(crate) note: usize,
}

impl<'a> FromIterator<&'a Diagnostic> for Counts {
    fn from_iter<I: IntoIterator<Item = &'a Diagnostic>>(diagnostics: I) -> Self {
        let mut counts = Self::default();
        for diagnostic in diagnostics {
            match diagnostic.level {
                Level::Deny => counts.deny += 1,
                Level::Warn => counts.warn += 1,
                Level::Note => counts.note += 1,
                Level::Allow => {}
            }
        }
        counts
    }
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.deny += other.deny;
        self.warn += other.warn;
        self.note += other.note;
    }
}

impl fmt::Display for Counts {
    /// `1 error, 2 warnings`; `no findings`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counts = [
            (Level::Deny, self.deny),
            (Level::Warn, self.warn),
            (Level::Note, self.note),
        ];
        let found = counts.into_iter().filter(|(_, number)| *number > 0);
        let found: Vec<String> = found.map(|(level, number)| render::count(level, number)).collect();
        if found.is_empty() {
            return f.write_str("no findings");
        }
        f.write_str(&found.join(", "))
    }
}
