//! `lexican format`: files in their canonical form.

use std::path::PathBuf;

use clap::Args;
use lexican_eds::{Reading, document::Problem, format};

use super::differences::{Difference, Differences};
use crate::{
    Verdict,
    failure::{self, Failure},
    input::{self, Input},
    output::{self, Stdout},
    parallel,
    patch::{self, Reader},
};

/// Write EDS and DCF files in their canonical form: order, spelling, counts, numbers
///
/// The device stays what it is, each comment stays with what it belongs to. Ends with 0; with --check or --diff with 1 when
/// a file is not in its canonical form; with 2 when one cannot be read or written.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Format {
    /// Files, directories with .eds and .dcf files in them, or `-` for standard input, which is written to standard output
    #[arg(required = true, value_name = "FILE|DIR")]
    paths: Vec<PathBuf>,

    /// Name the files that are not in their canonical form, and change nothing
    #[arg(long)]
    check: bool,

    /// Show what would change as a unified diff, and change nothing
    #[arg(long, conflicts_with = "check")]
    diff: bool,

    /// Say nothing of what was done
    #[arg(long, short)]
    quiet: bool,
}

const EXAMPLES: &str = "\
Examples:
  lexican format pump.eds
  lexican format --check devices
  lexican format --diff pump.eds
  lexican format - < pump.eds > canonical.eds";

/// A file before and after.
struct Formatted {
    input: Input,
    before: Reading,
    after: Reading,
}

impl Format {
    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        let mut inputs = Vec::new();
        let mut failures = Vec::new();
        for path in &self.paths {
            match input::expand(path) {
                Ok(found) => inputs.extend(found),
                Err(failure) => failures.push(failure),
            }
        }
        if self.diff {
            return self.differences(inputs, &failures);
        }
        let mut changed = 0;
        parallel::in_order(inputs, Formatted::of, |formatted| {
            match formatted.and_then(|formatted| self.write(&formatted)) {
                Ok(differs) => changed += usize::from(differs),
                Err(failure) => failures.push(failure),
            }
            Ok::<(), Failure>(())
        })?;
        for failure in &failures {
            failure.print();
        }
        Ok(match (failures.is_empty(), self.check && changed > 0) {
            (false, _) => Verdict::Incomplete,
            (true, true) => Verdict::Findings,
            (true, false) => Verdict::Clean,
        })
    }

    /// Writes the canonical form, or names the file. Whether it was in another form.
    fn write(&self, formatted: &Formatted) -> Result<bool, Failure> {
        let bytes = formatted.after.document.to_bytes();
        let differs = formatted.before.document.to_bytes() != bytes;
        let name = formatted.input.name();
        match &formatted.input {
            _ if self.check && differs && !self.quiet => failure::note(&format!("{name} is not in its canonical form")),
            _ if self.check => {}
            Input::Stdin => Stdout::plain().print_bytes(&bytes)?,
            Input::File(path) if differs => {
                output::rewrite(path, &bytes)?;
                if !self.quiet {
                    failure::note(&format!("{name} is in its canonical form now"));
                }
            }
            Input::File(_) => {}
        }
        Ok(differs)
    }

    /// Shows what would change.
    fn differences(&self, inputs: Vec<Input>, failures: &[Failure]) -> Result<Verdict, Failure> {
        let mut shown = Differences::new();
        for failure in failures {
            shown.fail(failure);
        }
        let reader = shown.reader();
        let difference = |input| Formatted::of(input).map(|formatted| formatted.difference(reader));
        parallel::in_order(inputs, difference, |difference| shown.add(difference))?;
        shown.finish(self.quiet, |files, _| match files {
            1 => "one file is not in its canonical form".to_owned(),
            files => format!("{files} files are not in their canonical form"),
        })
    }
}

impl Formatted {
    fn of(input: Input) -> Result<Self, Failure> {
        let name = input.name();
        let before = lexican_eds::read(name.clone(), input.read()?);
        if let [Problem::NotCanopen { .. }, ..] = before.document.problems() {
            return Err(Failure::new(format!(
                "{name} is no EDS; `lexican check {name}` says what it is"
            )));
        }
        let after =
            format::format(before.clone()).map_err(|error| Failure::new(format!("cannot format {name}: {error}")))?;
        Ok(Self { input, before, after })
    }

    fn difference(&self, reader: Reader) -> Difference {
        let (before, after) = (self.before.document.source(), self.after.document.source());
        Difference {
            text: patch::unified(before, after, reader),
            findings: 0,
        }
    }
}
