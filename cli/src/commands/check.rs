//! `lexican check`: files held against the rules.

use std::path::PathBuf;

use clap::Args;
use lexican_eds::rules::{self, Levels};

use super::levels::LevelArguments;
use crate::{
    Verdict,
    failure::Failure,
    format::{Checked, Format, Report},
    input::{self, Input},
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

    /// How to print the findings
    #[arg(long, value_enum, default_value_t)]
    format: Format,

    #[command(flatten)]
    levels: LevelArguments,
}

const EXAMPLES: &str = "\
Examples:
  lexican check pump.eds
  lexican check devices --level INI=allow --level EDS006=deny
  lexican check --format json - < pump.eds";

impl Check {
    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        let levels = self.levels.levels()?;
        let mut report = Report::default();
        for path in &self.paths {
            match input::expand(path) {
                Ok(inputs) => inputs.iter().for_each(|input| check(input, &levels, &mut report)),
                Err(failure) => report.failures.push(failure),
            }
        }
        self.format.print(&report)?;
        Ok(report.verdict())
    }
}

fn check(input: &Input, levels: &Levels, report: &mut Report) {
    match input.read() {
        Ok(bytes) => {
            let reading = lexican_eds::read(input.name(), bytes);
            report.checked.push(Checked {
                diagnostics: rules::check(&reading, levels),
                document: reading.document,
            });
        }
        Err(failure) => report.failures.push(failure),
    }
}
