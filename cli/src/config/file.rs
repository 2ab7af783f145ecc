//! A configuration that makes sense: rules that exist, patterns that can be matched.

use std::{
    fs,
    path::{Component, MAIN_SEPARATOR, Path, PathBuf},
};

use glob::{MatchOptions, Pattern};
use lexican_eds::rules::{LevelChange, Levels};
use toml::Spanned;

use super::{
    Settings, absolute,
    text::{self, Named},
};
use crate::failure::Failure;

/// What a `lexican.toml` says.
#[derive(Debug)]
pub(super) struct Config {
    /// The folder it is in; patterns start there.
    folder: PathBuf,
    settings: Settings,
    overrides: Vec<Override>,
}

/// What is different for some files.
#[derive(Debug)]
struct Override {
    files: Vec<Pattern>,
    settings: Settings,
}

impl Config {
    pub(super) fn read(path: &Path) -> Result<Self, Failure> {
        let text = fs::read_to_string(path);
        let text = text.map_err(|error| Failure::io("cannot read", &path.display().to_string(), &error))?;
        let named = Named { path, text: &text };
        let words = named.parse()?;
        let overrides = words.overrides.iter().map(|some| named.overriding(some));
        Ok(Self {
            folder: absolute(path.parent().unwrap_or(path)),
            settings: Settings {
                levels: named.levels(&words.levels)?,
                profile: words.profile,
            },
            overrides: overrides.collect::<Result<_, _>>()?,
        })
    }

    /// What holds for `file`, an absolute path; without one for what has no path.
    pub(super) fn settings(&self, file: Option<&Path>) -> Settings {
        let inside = file.and_then(|file| file.strip_prefix(&self.folder).ok());
        let applying = self
            .overrides
            .iter()
            .filter(|some| inside.is_some_and(|file| some.applies(file)));
        applying.fold(self.settings.clone(), |settings, some| settings.then(&some.settings))
    }
}

impl Settings {
    /// With what `later` says in addition or instead.
    pub(crate) fn then(self, later: &Self) -> Self {
        Self {
            levels: self.levels.then(later.levels.clone()),
            profile: later.profile.or(self.profile),
        }
    }
}

impl Override {
    fn applies(&self, file: &Path) -> bool {
        self.files.iter().any(|pattern| matches(pattern, file))
    }
}

/// A pattern without a slash is one of names, in any folder; `*` stays within a name, `**` does not.
fn matches(pattern: &Pattern, file: &Path) -> bool {
    let options = MatchOptions {
        require_literal_separator: true,
        ..MatchOptions::new()
    };
    let names = file.components().filter_map(|component| match component {
        Component::Normal(name) => name.to_str(),
        _ => None,
    });
    let names: Vec<&str> = names.collect();
    match names.last() {
        Some(name) if !pattern.as_str().contains(MAIN_SEPARATOR) => pattern.matches_with(name, options),
        _ => pattern.matches_with(&names.join(std::path::MAIN_SEPARATOR_STR), options),
    }
}

impl Named<'_> {
    fn overriding(&self, words: &text::Override) -> Result<Override, Failure> {
        let files = words.files.iter().map(|pattern| self.pattern(pattern));
        Ok(Override {
            files: files.collect::<Result<_, _>>()?,
            settings: Settings {
                levels: self.levels(&words.levels)?,
                profile: words.profile,
            },
        })
    }

    fn levels(&self, words: &text::Levels) -> Result<Levels, Failure> {
        words.iter().try_fold(Levels::default(), |levels, (selector, level)| {
            let known = level.get_ref().parse();
            let known = known.map_err(|error: lexican_eds::diagnostic::UnknownLevel| {
                self.failure(level.span(), &error.to_string())
            })?;
            let change = LevelChange::new(selector.get_ref(), known);
            let change = change.map_err(|error| self.failure(selector.span(), &error.to_string()))?;
            Ok(levels.with(change))
        })
    }

    fn pattern(&self, word: &Spanned<String>) -> Result<Pattern, Failure> {
        let text = word.get_ref().replace('/', std::path::MAIN_SEPARATOR_STR);
        let below = if text.ends_with(MAIN_SEPARATOR) { "**" } else { "" };
        let pattern = Pattern::new(&(text + below));
        pattern.map_err(|error| self.failure(word.span(), &format!("bad pattern `{}`: {}", word.get_ref(), error.msg)))
    }
}
