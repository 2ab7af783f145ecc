//! `lexican validate`: what a device answered, held against its file.

use std::path::{Path, PathBuf};

use clap::Args;
use lexican_eds::{Reading, diagnostic::Level, document::Problem, dump::Dump, render, rules};

use super::{settings::SettingsArguments, shown::ShownArguments};
use crate::{
    Verdict,
    config::Settings,
    failure::{self, Failure},
    format::{Printer, Subject},
    input::Input,
};

/// Hold what a device answered against its EDS or DCF file
///
/// Reports each difference at its place in the file, with its rule and the cure. Ends with 0 when nothing is found at level
/// deny, with 1 when something is, with 2 when a file cannot be read.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Validate {
    /// The EDS or DCF file of the device, or `-` for standard input
    eds: PathBuf,

    /// What the device answered: JSON as docs/dump-format.md of the repository describes it, or `-` for standard input
    dump: PathBuf,

    #[command(flatten)]
    shown: ShownArguments,

    #[command(flatten)]
    settings: SettingsArguments,
}

const EXAMPLES: &str = "\
Examples:
  lexican validate pump.eds node5.json
  lexican validate pump.dcf node5.json --level DMP002=allow --level DMP019=deny
  lexican validate --format json pump.eds - < node5.json";

impl Validate {
    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        let settings = self.settings.of(&Input::new(&self.eds))?;
        if self.eds == self.dump {
            let path = self.eds.display();
            return Err(Failure::new(format!(
                "{path} cannot be both; name the EDS file, then the dump"
            )));
        }
        let reading = self.read_eds()?;
        let dump = read_dump(&self.dump)?;
        mention_own_findings(&reading, &settings);
        let style = self.shown.style();
        let mut printer = Printer::new(style, Subject::Device)?;
        let found = rules::validate(&reading, &dump, &settings.levels);
        printer.file(style.render(&reading.document, found))?;
        printer.finish()
    }

    /// A file that describes something: held against nothing, every device would differ.
    fn read_eds(&self) -> Result<Reading, Failure> {
        let input = Input::new(&self.eds);
        let name = input.name();
        let bytes = input.read()?;
        if is_json(&bytes) {
            return Err(Failure::new(format!(
                "{name} is JSON, not an EDS; the EDS file comes first, then the dump"
            )));
        }
        let reading = lexican_eds::read(name.clone(), bytes);
        let is_foreign = matches!(reading.document.problems(), [Problem::NotCanopen { .. }, ..]);
        if is_foreign || reading.dictionary.objects.is_empty() {
            return Err(Failure::new(format!(
                "{name} describes no object; `lexican check {name}` says what it is"
            )));
        }
        Ok(reading)
    }
}

fn is_json(bytes: &[u8]) -> bool {
    let text = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    text.trim_ascii_start().first() == Some(&b'{')
}

fn read_dump(path: &Path) -> Result<Dump, Failure> {
    let input = Input::new(path);
    let bytes = input.read()?;
    Dump::from_json(&bytes).map_err(|error| Failure::new(format!("{}:{error}; {}", input.name(), error.help())))
}

/// A file that is wrong itself makes wrong differences.
fn mention_own_findings(reading: &Reading, settings: &Settings) {
    let found = settings.check(reading);
    let errors = found
        .iter()
        .filter(|diagnostic| diagnostic.level == Level::Deny)
        .count();
    if errors > 0 {
        let (name, count) = (reading.document.source().name(), render::count(Level::Deny, errors));
        failure::note(&format!("{name} itself has {count}; `lexican check {name}` shows them"));
    }
}
