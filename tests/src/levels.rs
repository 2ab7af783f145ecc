//! Levels that tests take.

use lexican_eds::{
    diagnostic::Level,
    rules::{self, LevelChange, Levels},
};

/// The rules' own levels, but that those which are off are heard as notes.
#[must_use]
pub fn every_rule() -> Levels {
    let off = rules::all().iter().filter(|rule| rule.level() == Level::Allow);
    let changes = off.filter_map(|rule| LevelChange::new(rule.code().as_str(), Level::Note).ok());
    changes.fold(Levels::default(), Levels::with)
}
