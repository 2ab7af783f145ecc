//! One subcommand a file.

mod check;
mod completions;
mod decode;
mod diff;
mod differences;
mod dump;
mod explain;
mod fix;
mod format;
mod generate;
mod live;
mod man;
mod new;
mod nodes;
mod recorded;
mod settings;
mod shown;
mod simulate;
mod validate;

use clap::Subcommand;

use crate::{Verdict, failure::Failure};

#[derive(Subcommand)]
pub(crate) enum Command {
    Check(check::Check),
    Decode(decode::Decode),
    Diff(diff::Diff),
    Dump(dump::DumpDevice),
    Explain(explain::Explain),
    Format(format::Format),
    Generate(generate::Generate),
    New(new::New),
    Simulate(simulate::Simulate),
    Validate(validate::Validate),
    Completions(completions::Completions),
    Man(man::Man),
}

impl Command {
    /// `explain CODE`
    pub(crate) fn explain(code: String) -> Self {
        Self::Explain(explain::Explain::of(code))
    }

    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        match self {
            Self::Check(check) => check.run(),
            Self::Decode(decode) => decode.run(),
            Self::Diff(diff) => diff.run(),
            Self::Dump(dump) => dump.run(),
            Self::Explain(explain) => explain.run(),
            Self::Format(format) => format.run(),
            Self::Generate(generate) => generate.run(),
            Self::New(new) => new.run(),
            Self::Simulate(simulate) => simulate.run(),
            Self::Validate(validate) => validate.run(),
            Self::Completions(completions) => completions.run(),
            Self::Man(man) => man.run(),
        }
    }
}
