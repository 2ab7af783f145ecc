//! Which rules a user hears of, and how loud.

use std::{fmt, str::FromStr};

use super::{Rule, find, registry, similar};
use crate::diagnostic::{Level, UnknownLevel};

/// The user's changes to the rules' levels.
///
/// ```
/// use lexican_eds::{diagnostic::Level, rules::{self, Levels}};
///
/// let levels = Levels::default().with("INI=allow".parse()?).with("INI002=deny".parse()?);
/// let rule = rules::find("INI002").ok_or("no such rule")?;
/// assert_eq!(levels.of(rule), Level::Deny);
///
/// let levels = levels.then(Levels::default().with("INI=note".parse()?));
/// assert_eq!(levels.of(rule), Level::Note);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Levels {
    /// The last one that has something to say of a rule holds for it.
    layers: Vec<Vec<LevelChange>>,
}

impl Levels {
    /// With one more change. A change of a code beats one of its family; of two alike the later holds.
    #[must_use]
    pub fn with(mut self, change: LevelChange) -> Self {
        match self.layers.last_mut() {
            Some(layer) => layer.push(change),
            None => self.layers.push(vec![change]),
        }
        self
    }

    /// With the changes of `later`, which beat those that are here already: a family there a code here, too.
    #[must_use]
    pub fn then(mut self, later: Self) -> Self {
        self.layers.extend(later.layers);
        self
    }

    /// The level that holds for `rule`.
    #[must_use]
    pub fn of(&self, rule: &Rule) -> Level {
        let change = self.layers.iter().rev().find_map(|layer| change(layer, rule));
        change.map_or(rule.level(), |change| change.level)
    }
}

/// What `layer` has to say of `rule`.
fn change<'a>(layer: &'a [LevelChange], rule: &Rule) -> Option<&'a LevelChange> {
    let code = rule.code();
    let last = |selector: &str| layer.iter().rev().find(|change| change.selector == selector);
    last(code.as_str()).or_else(|| last(code.family()))
}

/// A new level for a rule or a family: `EDS004=warn`, `INI=allow`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LevelChange {
    /// A code or a family that exists.
    selector: &'static str,
    level: Level,
}

impl LevelChange {
    /// Gives `level` to the rule or the family `selector`, in any case.
    ///
    /// # Errors
    /// When there is neither a rule nor a family of that name.
    pub fn new(selector: &str, level: Level) -> Result<Self, UnknownRule> {
        let selector = known(selector).ok_or_else(|| UnknownRule(selector.to_owned()))?;
        Ok(Self { selector, level })
    }

    /// The code or the family.
    #[must_use]
    pub const fn selector(&self) -> &'static str {
        self.selector
    }

    /// The new level.
    #[must_use]
    pub const fn level(&self) -> Level {
        self.level
    }
}

/// The code or family of that name, in any case.
pub(super) fn known(selector: &str) -> Option<&'static str> {
    let family = registry::FAMILIES.iter().map(|family| family.letters);
    let mut families = family.filter(|letters| letters.eq_ignore_ascii_case(selector));
    families.next().or_else(|| Some(find(selector)?.code().as_str()))
}

impl FromStr for LevelChange {
    type Err = LevelChangeError;

    fn from_str(text: &str) -> Result<Self, LevelChangeError> {
        let (selector, level) = text.split_once('=').ok_or(LevelChangeError::Form)?;
        let level = level.trim().parse().map_err(LevelChangeError::Level)?;
        Self::new(selector.trim(), level).map_err(LevelChangeError::Rule)
    }
}

/// Why a text is no [`LevelChange`].
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LevelChangeError {
    /// It has no `=`.
    Form,
    /// The code or family does not exist.
    Rule(UnknownRule),
    /// The level does not exist.
    Level(UnknownLevel),
}

impl fmt::Display for LevelChangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Form => f.write_str("write CODE=LEVEL, such as EDS004=warn or INI=allow"),
            Self::Rule(error) => error.fmt(f),
            Self::Level(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for LevelChangeError {}

/// No rule and no family has this name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownRule(pub String);

impl fmt::Display for UnknownRule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "unknown rule `{}`", self.0)?;
        let codes = super::all().iter().map(|rule| rule.code().as_str());
        match similar(&self.0, codes) {
            Some(code) => write!(f, "; did you mean {code}?"),
            None => f.write_str("; `lexican explain` lists them all"),
        }
    }
}

impl std::error::Error for UnknownRule {}
