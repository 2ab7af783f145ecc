//! What of the findings is shown, and how: arguments that several commands take.

use clap::{
    Args,
    builder::{PossibleValuesParser, TypedValueParser as _},
};
use lexican_eds::diagnostic::Level;

use crate::format::{Format, Style};

#[derive(Args)]
pub(crate) struct ShownArguments {
    /// How to print the findings
    #[arg(long, value_enum, default_value_t)]
    format: Format,

    /// Show findings of this level and above; the exit code stays the same
    #[arg(long, value_name = "LEVEL", default_value = "note", value_parser = levels())]
    min_level: Level,

    /// Print findings and nothing else: no summary, no progress
    #[arg(long, short)]
    quiet: bool,
}

impl ShownArguments {
    pub(crate) fn style(&self) -> Style {
        Style {
            format: self.format,
            min_level: self.min_level,
            quiet: self.quiet,
        }
    }
}

fn levels() -> impl clap::builder::TypedValueParser<Value = Level> {
    let names = [Level::Note, Level::Warn, Level::Deny].map(Level::name);
    PossibleValuesParser::new(names).try_map(|name| name.parse::<Level>())
}
