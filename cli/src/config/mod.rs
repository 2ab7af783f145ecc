//! `lexican.toml`: what holds for the files below it, unless an argument says otherwise. docs/config.md describes it.

mod file;
mod text;

use std::{
    collections::HashMap,
    fs,
    path::{Path, PathBuf},
    rc::Rc,
};

use lexican_eds::{
    Reading,
    diagnostic::Diagnostic,
    rules::{self, Levels},
};

use crate::{failure::Failure, input::Input};
use file::Config;

/// The name that is looked for in a file's folder and those above.
const NAME: &str = "lexican.toml";

/// What holds for one file.
#[derive(Clone, Debug, Default)]
pub(crate) struct Settings {
    pub(crate) levels: Levels,
    /// The device profile that it is held against, whatever its 1000h says.
    pub(crate) profile: Option<u16>,
}

impl Settings {
    /// What is wrong with a file by these settings.
    pub(crate) fn check(&self, reading: &Reading) -> Vec<Diagnostic> {
        let profile = self.profile.unwrap_or_else(|| rules::profile(&reading.dictionary));
        rules::check_as(reading, &self.levels, profile)
    }
}

/// Where settings come from.
#[derive(Clone, Debug, Default)]
pub(crate) enum Origin {
    /// From the `lexican.toml` nearest to each file, in its folder or above.
    #[default]
    Nearest,
    /// From this one.
    File(PathBuf),
    /// From arguments alone.
    None,
}

/// The configurations of a run, each read once.
pub(crate) struct Configs {
    origin: Origin,
    /// What beats them all.
    arguments: Settings,
    /// By folder, as it is spelled.
    nearest: HashMap<PathBuf, Option<Rc<Config>>>,
}

impl Configs {
    /// From `origin`; `arguments` beat what is found there.
    pub(crate) fn new(origin: Origin, arguments: Settings) -> Self {
        Self {
            origin,
            arguments,
            nearest: HashMap::new(),
        }
    }

    /// What holds for `input`.
    pub(crate) fn settings(&mut self, input: &Input) -> Result<Settings, Failure> {
        let folder = match input {
            Input::File(path) => path.parent().unwrap_or(path),
            Input::Stdin => Path::new(""),
        };
        let file = match input {
            Input::File(path) => Some(absolute(folder).join(path.file_name().unwrap_or_default())),
            Input::Stdin => None,
        };
        let config = self.config(folder)?;
        let configured = config.map_or_else(Settings::default, |config| config.settings(file.as_deref()));
        Ok(configured.then(&self.arguments))
    }

    fn config(&mut self, folder: &Path) -> Result<Option<Rc<Config>>, Failure> {
        if let Some(known) = self.nearest.get(folder) {
            return Ok(known.clone());
        }
        let path = match &self.origin {
            Origin::Nearest => nearest(folder),
            Origin::File(path) => Some(path.clone()),
            Origin::None => None,
        };
        let config = path.map(|path| Config::read(&path)).transpose()?.map(Rc::new);
        self.nearest.insert(folder.to_owned(), config.clone());
        Ok(config)
    }
}

/// The configuration in `folder`, or in the first folder above it that has one.
fn nearest(folder: &Path) -> Option<PathBuf> {
    let absolute = absolute(folder);
    let found = absolute
        .ancestors()
        .map(|folder| folder.join(NAME))
        .find(|path| path.is_file());
    found.map(|path| shortened(&path))
}

/// The folder as the system knows it: without links, and without `..`, whose parent is not the text before it.
fn absolute(folder: &Path) -> PathBuf {
    let folder = if folder.as_os_str().is_empty() {
        Path::new(".")
    } else {
        folder
    };
    fs::canonicalize(folder).unwrap_or_else(|_| folder.to_owned())
}

/// As a person in the working directory would call it.
fn shortened(path: &Path) -> PathBuf {
    path.strip_prefix(absolute(Path::new("."))).unwrap_or(path).to_owned()
}
