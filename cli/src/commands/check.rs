//! `lexican check`: files held against the rules.

use std::path::PathBuf;

use clap::Args;

use super::{settings::SettingsArguments, shown::ShownArguments};
use crate::{
    Verdict,
    config::Settings,
    failure::Failure,
    format::{Printer, Rendered, Style, Subject},
    input::{self, Input},
    parallel,
    progress::Progress,
};

/// Check EDS and DCF files against the standard
///
/// Reports each finding with its place, its rule and the cure. Ends with 0 when nothing is found at level deny, with 1
/// when something is, with 2 when a file cannot be read.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Check {
    /// Files, directories with .eds and .dcf files in them, or `-` for standard input
    #[arg(required = true, value_name = "FILE|DIR")]
    paths: Vec<PathBuf>,

    #[command(flatten)]
    shown: ShownArguments,

    #[command(flatten)]
    settings: SettingsArguments,
}

const EXAMPLES: &str = "\
Examples:
  lexican check pump.eds
  lexican check devices --level INI=allow --level EDS006=deny
  lexican check --format json - < pump.eds";

impl Check {
    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        let (inputs, failures) = self.inputs();
        let mut configs = self.settings.configs()?;
        let with_settings = |input| Ok((configs.settings(&input)?, input));
        let inputs: Vec<_> = inputs.into_iter().map(with_settings).collect::<Result<_, _>>()?;
        let style = self.shown.style();
        let mut printer = Printer::new(style, Subject::File)?;
        for failure in failures {
            printer.failure(failure);
        }
        let mut progress = Progress::new(inputs.len(), !style.quiet);
        let check = |(settings, input): (Settings, Input)| check(&input, &settings, style);
        parallel::in_order(inputs, check, |checked| {
            progress.advance();
            match checked {
                Ok(rendered) => progress.aside(|| printer.file(rendered))?,
                Err(failure) => printer.failure(failure),
            }
            Ok(())
        })?;
        drop(progress);
        printer.finish()
    }

    /// The files, in the order of the arguments, and why others are not among them.
    fn inputs(&self) -> (Vec<Input>, Vec<Failure>) {
        let mut inputs = Vec::new();
        let mut failures = Vec::new();
        for path in &self.paths {
            match input::expand(path) {
                Ok(found) => inputs.extend(found),
                Err(failure) => failures.push(failure),
            }
        }
        (inputs, failures)
    }
}

/// Reads the file and lets go of it: of a thousand files only what there is to say is kept.
fn check(input: &Input, settings: &Settings, style: Style) -> Result<Rendered, Failure> {
    let reading = lexican_eds::read(input.name(), input.read()?);
    let found = settings.check(&reading);
    Ok(style.render(reading.document.source(), found))
}
