//! How findings are printed: one format a file.

mod counts;
mod json;
mod text;

use std::io;

use clap::ValueEnum;
use lexican_eds::{diagnostic::Diagnostic, document::Document};

pub(crate) use counts::Counts;

use crate::{
    Verdict,
    failure::Failure,
    output::{Stdout, unwritten},
};

/// An output format.
#[derive(Clone, Copy, Default, ValueEnum)]
pub(crate) enum Format {
    /// For people: the line, a caret under the value, the cure
    #[default]
    Text,
    /// For programs, as docs/json.md of the repository describes it
    Json,
}

/// A file and what is wrong with it.
pub(crate) struct Checked {
    pub(crate) document: Document,
    pub(crate) diagnostics: Vec<Diagnostic>,
}

/// What was checked.
#[derive(Clone, Copy, Default)]
pub(crate) enum Subject {
    #[default]
    File,
    /// A device, against its file.
    Device,
}

/// All that a run of `check` or `validate` has to say.
#[derive(Default)]
pub(crate) struct Report {
    pub(crate) subject: Subject,
    pub(crate) checked: Vec<Checked>,
    /// Files and directories that could not be read.
    pub(crate) failures: Vec<Failure>,
}

impl Report {
    pub(crate) fn verdict(&self) -> Verdict {
        match (self.failures.is_empty(), self.counts().deny) {
            (false, _) => Verdict::Incomplete,
            (true, 0) => Verdict::Clean,
            (true, _) => Verdict::Findings,
        }
    }

    fn counts(&self) -> Counts {
        self.checked.iter().flat_map(|checked| &checked.diagnostics).collect()
    }
}

impl Format {
    /// Prints the findings to standard output, what could not be read to standard error.
    pub(crate) fn print(self, report: &Report) -> Result<(), Failure> {
        match self {
            Self::Text => write(text::write, report, Stdout::styled()),
            Self::Json => write(json::write, report, Stdout::plain()),
        }?;
        report.failures.iter().for_each(Failure::print);
        Ok(())
    }
}

fn write(
    write: impl Fn(&Report, &mut Stdout) -> io::Result<()>,
    report: &Report,
    mut stdout: Stdout,
) -> Result<(), Failure> {
    write(report, &mut stdout).map_err(|error| unwritten(&error))?;
    stdout.finish()
}
