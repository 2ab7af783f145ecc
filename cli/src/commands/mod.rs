//! One subcommand a file.

mod check;
mod explain;
mod generate;
mod levels;

use clap::Subcommand;

use crate::{Verdict, failure::Failure};

#[derive(Subcommand)]
pub(crate) enum Command {
    Check(check::Check),
    Explain(explain::Explain),
    Generate(generate::Generate),
}

impl Command {
    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        match self {
            Self::Check(check) => check.run(),
            Self::Explain(explain) => explain.run(),
            Self::Generate(generate) => generate.run(),
        }
    }
}
