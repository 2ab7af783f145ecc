//! `lexican check`: files held against the rules.

use std::path::PathBuf;

use clap::Args;

use super::{differences::Differences, fix, settings::SettingsArguments, shown::ShownArguments};
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

    /// Make the cures that are safe in the files, and report what is left; standard input is written to standard output
    #[arg(long)]
    fix: bool,

    /// Show what --fix would change as a unified diff, and change nothing; ends with 1 when there is something
    #[arg(long, conflicts_with_all = ["fix", "format", "min_level"])]
    diff: bool,

    #[command(flatten)]
    settings: SettingsArguments,
}

const EXAMPLES: &str = "\
Examples:
  lexican check pump.eds
  lexican check devices --level INI=allow --level EDS006=deny
  lexican check --format json - < pump.eds
  lexican check --diff devices
  lexican check --fix pump.eds";

impl Check {
    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        let (inputs, failures) = self.inputs();
        let mut configs = self.settings.configs()?;
        let with_settings = |input| Ok((configs.settings(&input)?, input));
        let inputs: Vec<_> = inputs.into_iter().map(with_settings).collect::<Result<_, _>>()?;
        let is_stdin = |(_, input): &(_, Input)| matches!(input, Input::Stdin);
        match inputs.as_slice() {
            _ if self.diff => self.differences(inputs, &failures),
            [(settings, Input::Stdin)] if self.fix => fix::stdin(settings, self.shown.style()),
            inputs if self.fix && inputs.iter().any(is_stdin) => Err(Failure::new(
                "--fix writes standard input to standard output; name `-` alone",
            )),
            _ => self.findings(inputs, failures),
        }
    }

    fn findings(&self, inputs: Vec<(Settings, Input)>, failures: Vec<Failure>) -> Result<Verdict, Failure> {
        let style = self.shown.style();
        let mut printer = Printer::new(style, Subject::File)?;
        for failure in failures {
            printer.failure(failure);
        }
        let mut progress = Progress::new(inputs.len(), !style.quiet);
        let check = |(settings, input): (Settings, Input)| {
            if self.fix {
                fix::file(&input, &settings, style)
            } else {
                check(&input, &settings, style)
            }
        };
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

    /// Shows what the cures would change.
    fn differences(&self, inputs: Vec<(Settings, Input)>, failures: &[Failure]) -> Result<Verdict, Failure> {
        let mut shown = Differences::new();
        for failure in failures {
            shown.fail(failure);
        }
        let reader = shown.reader();
        let difference = |(settings, input): (Settings, Input)| fix::difference(&input, &settings, reader);
        parallel::in_order(inputs, difference, |difference| shown.add(difference))?;
        shown.finish(self.shown.style().quiet, |files, number| {
            let (files, number) = (count(files, "file"), count(number, "finding"));
            format!("`--fix` mends {number} in {files}")
        })
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
    Ok(style.render(&reading.document, found))
}

/// `3 findings`
fn count(number: usize, thing: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {thing}{plural}")
}
