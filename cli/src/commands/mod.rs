//! One subcommand a file.

mod check;
mod differences;
mod explain;
mod fix;
mod generate;
mod settings;
mod shown;
mod validate;

use clap::Subcommand;

use crate::{Verdict, failure::Failure};

#[derive(Subcommand)]
pub(crate) enum Command {
    Check(check::Check),
    Explain(explain::Explain),
    Generate(generate::Generate),
    Validate(validate::Validate),
}

impl Command {
    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        match self {
            Self::Check(check) => check.run(),
            Self::Explain(explain) => explain.run(),
            Self::Generate(generate) => generate.run(),
            Self::Validate(validate) => validate.run(),
        }
    }
}
