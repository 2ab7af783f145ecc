//! `lexican completions`: for shells that complete what is typed.

use clap::{Args, CommandFactory as _};
use clap_complete::Shell;

use crate::{Arguments, Verdict, failure::Failure, output::Stdout};

/// Print a script by which a shell completes commands and options
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Completions {
    /// The shell
    shell: Shell,
}

const EXAMPLES: &str = "\
Examples:
  lexican completions bash > ~/.local/share/bash-completion/completions/lexican
  lexican completions zsh > ~/.zfunc/_lexican
  lexican completions fish > ~/.config/fish/completions/lexican.fish";

impl Completions {
    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut Arguments::command(), "lexican", &mut script);
        Stdout::plain().print(&String::from_utf8_lossy(&script))?;
        Ok(Verdict::Clean)
    }
}
