//! The `lexican` command: arguments, files and the terminal. What it says comes from the library crates.
//!
//! | module | does |
//! |---|---|
//! | `commands` | one subcommand a file: its arguments and what it does with them |
//! | `config` | `lexican.toml` |
//! | `format` | one output format of `check` and `validate` a file |
//! | `parallel`, `progress` | many files at once, and a bar for those who wait |
//! | `input`, `output` | the only reading and writing of files and streams |
//! | `patch` | unified diffs |
//! | `scaffold` | the files of a new firmware crate |
//! | `failure` | why a command could not run, in one line |

mod commands;
mod config;
mod failure;
mod format;
mod input;
mod output;
mod parallel;
mod patch;
mod progress;
mod scaffold;

use std::{io::Write as _, process::ExitCode};

use clap::{CommandFactory, Parser, ValueEnum, error::ErrorKind};

use commands::Command;

/// The object dictionary compiler for CANopen
///
/// Checks EDS and DCF files against the CiA standards and generates Rust from them.
#[derive(Parser)]
#[command(version, max_term_width = 100, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,

    /// Explain a rule, as `lexican explain CODE` does
    #[arg(long, value_name = "CODE", display_order = 99)]
    explain: Option<String>,

    /// When to colour the output; `auto` asks the terminal and NO_COLOR
    #[arg(
        long,
        value_enum,
        value_name = "WHEN",
        default_value_t,
        global = true,
        display_order = 100
    )]
    color: Color,
}

#[derive(Clone, Copy, Default, ValueEnum)]
enum Color {
    #[default]
    Auto,
    Always,
    Never,
}

/// What a command came to. A failure to run ends with 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Verdict {
    /// 0
    Clean,
    /// 1: there are findings at deny.
    Findings,
    /// 2: a part of the work could not be done, and stderr says which.
    Incomplete,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    arguments.color.choose();
    match arguments.into_command().run() {
        Ok(verdict) => ExitCode::from(verdict as u8),
        Err(failure) => {
            failure.print();
            ExitCode::from(Verdict::Incomplete as u8)
        }
    }
}

impl Arguments {
    /// What is to be done; ends with a word about the usage when that is nothing.
    fn into_command(self) -> Command {
        match (self.explain, self.command) {
            (Some(code), _) => Command::explain(code),
            (None, Some(command)) => command,
            (None, None) => {
                let mut usage = Self::command();
                usage.error(ErrorKind::MissingSubcommand, "a command is missing").exit()
            }
        }
    }
}

impl Color {
    /// Sets what [`anstream`] does with the escape sequences that are written to it.
    fn choose(self) {
        match self {
            Self::Auto => anstream::ColorChoice::Auto,
            Self::Always => anstream::ColorChoice::Always,
            Self::Never => anstream::ColorChoice::Never,
        }
        .write_global();
    }
}

impl failure::Failure {
    /// Nobody is left to hear of it when stderr is gone.
    pub(crate) fn print(&self) {
        let style = anstyle::AnsiColor::BrightRed.on_default().bold();
        let _ = writeln!(anstream::stderr(), "{style}error{style:#}: {self}");
    }
}
