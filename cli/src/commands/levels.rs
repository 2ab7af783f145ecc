//! `--level`, which several commands take.

use clap::Args;
use lexican_eds::rules::{LevelChange, Levels};

use crate::failure::Failure;

#[derive(Args)]
pub(crate) struct LevelArguments {
    /// Change the level of a rule or a family to allow, note, warn or deny: EDS004=warn, INI=allow; may be repeated
    #[arg(long = "level", value_name = "CODE=LEVEL")]
    changes: Vec<String>,
}

impl LevelArguments {
    /// The levels of all rules after the changes.
    pub(crate) fn levels(&self) -> Result<Levels, Failure> {
        Ok(self.changes()?.into_iter().fold(Levels::default(), Levels::with))
    }

    /// The changes, in the order of the arguments.
    pub(crate) fn changes(&self) -> Result<Vec<LevelChange>, Failure> {
        self.changes.iter().map(|change| parse(change)).collect()
    }
}

fn parse(change: &str) -> Result<LevelChange, Failure> {
    let parsed = change.parse::<LevelChange>();
    parsed.map_err(|error| Failure::new(format!("--level {change}: {error}")))
}
