//! The words of `lexican.toml`, each with its place.

use std::{collections::BTreeMap, ops::Range, path::Path};

use serde::Deserialize;
use toml::Spanned;

use crate::failure::Failure;

/// The file as written.
#[derive(Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct Text {
    pub(super) profile: Option<u16>,
    pub(super) levels: Levels,
    #[serde(rename = "override")]
    pub(super) overrides: Vec<Override>,
}

/// What is different for some files.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Override {
    pub(super) files: Vec<Spanned<String>>,
    pub(super) profile: Option<u16>,
    #[serde(default)]
    pub(super) levels: Levels,
}

/// A code or a family, and its level.
pub(super) type Levels = BTreeMap<Spanned<String>, Spanned<String>>;

/// A file's text and how messages call it.
pub(super) struct Named<'a> {
    pub(super) path: &'a Path,
    pub(super) text: &'a str,
}

impl Named<'_> {
    pub(super) fn parse(&self) -> Result<Text, Failure> {
        toml::from_str(self.text).map_err(|error| {
            let place = error.span().unwrap_or_default();
            self.failure(place, error.message())
        })
    }

    /// `lexican.toml:3:5: …`
    pub(super) fn failure(&self, place: Range<usize>, message: &str) -> Failure {
        let before = self.text.get(..place.start).unwrap_or(self.text);
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().unwrap_or_default().chars().count() + 1;
        let (path, message) = (self.path.display(), message.trim_end());
        Failure::new(format!("{path}:{line}:{column}: {}", message.replace('\n', "; ")))
    }
}
