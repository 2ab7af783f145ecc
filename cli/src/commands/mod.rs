//! One subcommand a file.

mod check;
mod explain;

use clap::Subcommand;

use crate::{Verdict, failure::Failure};

#[derive(Subcommand)]
pub(crate) enum Command {
    Check(check::Check),
    Explain(explain::Explain),
}

impl Command {
    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        match self {
            Self::Check(check) => check.run(),
            Self::Explain(explain) => explain.run(),
        }
    }
}
