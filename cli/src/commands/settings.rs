//! `--level`, `--profile`, `--config` and what else says how files are judged; arguments that several commands take.

use std::path::PathBuf;

use clap::Args;
use lexican_eds::rules::{LevelChange, Levels};

use crate::{
    config::{Configs, Origin, Settings},
    failure::Failure,
    input::Input,
};

#[derive(Args)]
pub(crate) struct SettingsArguments {
    /// Change the level of a rule or a family to allow, note, warn or deny: EDS004=warn, INI=allow; may be repeated
    #[arg(long = "level", value_name = "CODE=LEVEL")]
    changes: Vec<String>,

    /// Hold files against the device profile of this number, whatever their object 1000h says: 406 for encoders, 0 for none
    #[arg(long, value_name = "NUMBER")]
    profile: Option<u16>,

    /// Read settings from this file instead of the lexican.toml nearest to each file, in its folder or above
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,

    /// Pass over every lexican.toml
    #[arg(long, conflicts_with = "config")]
    no_config: bool,
}

impl SettingsArguments {
    /// What holds for `input`.
    pub(crate) fn of(&self, input: &Input) -> Result<Settings, Failure> {
        self.configs()?.settings(input)
    }

    /// Says what holds for one file after the other.
    pub(crate) fn configs(&self) -> Result<Configs, Failure> {
        let levels = self.changes.iter().try_fold(Levels::default(), |levels, change| {
            let change = parse(change)?;
            Ok(levels.with(change))
        })?;
        let profile = self.profile;
        let arguments = Settings { levels, profile };
        Ok(Configs::new(self.origin(), arguments))
    }

    fn origin(&self) -> Origin {
        match &self.config {
            _ if self.no_config => Origin::None,
            Some(path) => Origin::File(path.clone()),
            None => Origin::Nearest,
        }
    }
}

/// `EDS004=warn`
pub(super) fn parse(change: &str) -> Result<LevelChange, Failure> {
    let parsed = change.parse::<LevelChange>();
    parsed.map_err(|error| Failure::new(format!("--level {change}: {error}")))
}
