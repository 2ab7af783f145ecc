//! `lexican generate`: Rust, handler stubs and documentation made from a file.

use std::{
    io::Write as _,
    path::{Path, PathBuf},
};

use clap::Args;
use lexican_codegen::{Builder, Error, Generated, Selector, Template};
use lexican_eds::{
    diagnostic::{Diagnostic, Level},
    render::{Renderer, printable},
    source::Source,
};

use super::settings::SettingsArguments;
use crate::{Verdict, config::Settings, failure::Failure, format::Counts, input::Input, output};

/// Generate a Rust dictionary from an EDS or DCF file
///
/// Prints the source, or writes it to a file: one module, as build.rs makes it with the crate lexican-codegen. A file with
/// findings at level deny is refused with them and exit code 1; what cannot be read or written ends with 2.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Generate {
    /// The EDS or DCF file, or `-` for standard input
    file: PathBuf,

    /// Write to this file, whole or not at all, instead of to standard output
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,

    /// Generate a skeleton of the trait `Handlers` for the objects of --handle
    #[arg(long, group = "product")]
    stubs: bool,

    /// Generate the documentation of the dictionary in Markdown
    #[arg(long, group = "product")]
    docs: bool,

    /// Fill this template, in the language of Jinja, with the dictionary
    #[arg(long, group = "product", value_name = "FILE.j2")]
    template: Option<PathBuf>,

    /// Objects that the application answers for: hexadecimal indices, with sub-index where one value is meant
    #[arg(long, value_name = "INDEX[:SUB]", value_delimiter = ',')]
    handle: Vec<String>,

    /// The name of the generated module; the file's name otherwise
    #[arg(long, value_name = "NAME")]
    module: Option<String>,

    #[command(flatten)]
    settings: SettingsArguments,
}

const EXAMPLES: &str = "\
Examples:
  lexican generate pump.eds -o src/pump.rs
  lexican generate pump.eds --handle 6003,6004,1010:1 --stubs -o src/handlers.rs
  lexican generate pump.eds --docs > pump.md";

impl Generate {
    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        let input = Input::new(&self.file);
        let bytes = input.read()?;
        let reading = lexican_eds::read(input.name(), bytes.clone());
        let settings = self.settings.of(&input)?;
        let found = settings.check(&reading);
        let verdict = tell(reading.document.source(), &found);
        if verdict == Verdict::Clean {
            let generated = self.generate(input.name(), bytes, settings)?;
            let product = self.product(&generated)?;
            output::write(self.output.as_deref().unwrap_or(Path::new("-")), &product)?;
        }
        Ok(verdict)
    }

    fn generate(&self, name: String, bytes: Vec<u8>, settings: Settings) -> Result<Generated, Failure> {
        let mut builder = Builder::from_bytes(name, bytes)
            .levels(settings.levels)
            .handle(self.selectors()?);
        if let Some(name) = &self.module {
            builder = builder.module_name(name);
        }
        builder.generate().map_err(|error| failure(&error))
    }

    fn selectors(&self) -> Result<Vec<Selector>, Failure> {
        self.handle.iter().map(|text| selector(text)).collect()
    }

    /// What was asked for: source, stubs, documentation or a filled template.
    fn product(&self, generated: &Generated) -> Result<String, Failure> {
        let product = match &self.template {
            Some(path) => {
                let name = path.display().to_string();
                let text = Input::new(path).read_text()?;
                generated.render(&Template {
                    name: &name,
                    text: &text,
                })
            }
            None if self.stubs => generated.stubs(),
            None if self.docs => generated.docs(),
            None => Ok(generated.source().to_owned()),
        };
        product.map_err(|error| failure(&error))
    }
}

/// Shows on stderr what stands in the way, or says that there is something to look at.
pub(super) fn tell(source: &Source, found: &[Diagnostic]) -> Verdict {
    let denied = found.iter().filter(|diagnostic| diagnostic.level == Level::Deny);
    let renderer = Renderer::coloured();
    let mut text: String = denied
        .map(|diagnostic| renderer.render(source, diagnostic) + "\n")
        .collect();
    let counts: Counts = found.iter().collect();
    let refused = counts.deny > 0;
    if refused || counts.warn > 0 {
        let consequence = if refused {
            "no code is generated"
        } else {
            "`lexican check` shows them"
        };
        let summary = format!("{}: {counts}; {consequence}", source.name());
        text.push_str(&printable(&summary));
        text.push('\n');
    }
    // Nobody is left to hear of it when stderr is gone.
    let _ = anstream::stderr().write_all(text.as_bytes());
    if refused { Verdict::Findings } else { Verdict::Clean }
}

pub(super) fn failure(error: &Error) -> Failure {
    Failure::new(error.to_string())
}

/// `6003` or `1010:1`, in hexadecimal.
pub(super) fn selector(text: &str) -> Result<Selector, Failure> {
    let hex = |text: &str| u16::from_str_radix(text.trim().trim_start_matches("0x"), 16).ok();
    let parsed = match text.split_once(':') {
        Some((index, sub)) => (|| Some(Selector::Value(hex(index)?, u8::try_from(hex(sub)?).ok()?)))(),
        None => hex(text).map(Selector::Object),
    };
    parsed.ok_or_else(|| {
        Failure::new(format!(
            "--handle {text}: write an index, such as 6003, or index and sub-index, such as 1010:1"
        ))
    })
}
