//! `lexican man`: manual pages, for packages.

use std::{fs, io, path::PathBuf};

use clap::{Args, CommandFactory as _};
use clap_mangen::Man as Page;

use crate::{Arguments, Verdict, failure::Failure, output::Stdout};

/// Print the manual page of lexican or of one of its commands
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Man {
    /// The command whose page it is; lexican's own page otherwise
    #[arg(value_name = "COMMAND")]
    command: Option<String>,

    /// Write the pages of lexican and all its commands into this folder instead
    #[arg(short, long, value_name = "DIR", conflicts_with = "command")]
    output: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  lexican man check | man -l -
  lexican man -o /usr/local/share/man/man1";

impl Man {
    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        match &self.output {
            Some(folder) => write_all(folder).map_err(|error| {
                let folder = folder.display().to_string();
                Failure::io("cannot write the pages to", &folder, &error)
            })?,
            None => Stdout::plain().print(&page(self.command.as_deref())?)?,
        }
        Ok(Verdict::Clean)
    }
}

fn write_all(folder: &PathBuf) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    clap_mangen::generate_to(Arguments::command(), folder)
}

/// The page of lexican or of its command `name`.
fn page(name: Option<&str>) -> Result<String, Failure> {
    let mut lexican = Arguments::command();
    lexican.build();
    let unknown = |name| Failure::new(format!("there is no command `{name}`; `lexican --help` lists them all"));
    let command = match name {
        Some(name) => lexican.find_subcommand(name).ok_or_else(|| unknown(name))?,
        None => &lexican,
    };
    let mut page = Vec::new();
    // Writing to memory does not fail.
    let _ = Page::new(command.clone()).render(&mut page);
    Ok(String::from_utf8_lossy(&page).into_owned())
}
