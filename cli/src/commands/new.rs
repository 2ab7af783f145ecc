//! `lexican new`: a firmware crate made from a file.

use std::path::{Path, PathBuf};

use clap::Args;
use lexican_codegen::{Builder, Generated, Selector};
use lexican_eds::{
    ir,
    rules::{self, LevelChange, Levels},
};

use super::{
    generate::{failure, selector, tell},
    settings,
};
use crate::{
    Verdict,
    failure::{Failure, note},
    input::Input,
    output,
    scaffold::{self, Scaffold},
};

/// Write a firmware crate for the device of an EDS or DCF file
///
/// The crate builds and passes its tests as it is written: the file's copy, a build script that compiles it, handlers to
/// fill in, the device without clock and bus, a program that runs it on this computer, and a test that speaks SDO to it.
/// A file with findings at level deny is refused with them and exit code 1; what cannot be read or written ends with 2.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct New {
    /// The folder to make; its last part is the crate's name
    #[arg(value_name = "NAME")]
    path: PathBuf,

    /// The EDS or DCF file, or `-` for standard input
    #[arg(long, value_name = "FILE")]
    eds: PathBuf,

    /// Objects that the application answers for, as in `generate`; without it the first that a client may write, to show how
    #[arg(long, value_name = "INDEX[:SUB]", value_delimiter = ',')]
    handle: Vec<String>,

    /// The node-ID that the device starts with, 1 to 127; that of a DCF or 1 otherwise
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=127))]
    node_id: Option<u8>,

    /// Change the level of a rule or a family, as in `check`; the build script does the same
    #[arg(long = "level", value_name = "CODE=LEVEL")]
    levels: Vec<String>,

    /// Depend on the crates in this checkout of Lexican instead of the published ones
    #[arg(long, value_name = "FOLDER")]
    checkout: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  lexican new pump --eds pump.eds
  lexican new firmware/encoder --eds encoder.eds --handle 6003,6004 --node-id 32";

impl New {
    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        let package = package(&self.path)?;
        self.refuse_existing()?;
        let input = Input::new(&self.eds);
        let bytes = input.read()?;
        let reading = lexican_eds::read(input.name(), bytes.clone());
        let changes = self.changes()?;
        let levels = changes.iter().copied().fold(Levels::default(), Levels::with);
        let verdict = tell(reading.document.source(), &rules::check(&reading, &levels));
        if verdict == Verdict::Clean {
            let handled = self.handled(&reading.dictionary)?;
            let eds = self.file_name(package);
            let generated = generate(&eds, &bytes, levels, &handled)?;
            let scaffold = Scaffold {
                package,
                eds: &eds,
                node_id: self.node_id(&reading.dictionary),
                runtime: self.dependency("runtime")?,
                codegen: self.dependency("codegen")?,
                handled: &handled,
                levels: &changes,
            };
            self.write(&scaffold, &generated, &bytes)?;
        }
        Ok(verdict)
    }

    /// Before any work; the writing looks again.
    fn refuse_existing(&self) -> Result<(), Failure> {
        match self.path.symlink_metadata() {
            Ok(_) => Err(Failure::io(
                "cannot make",
                &self.path.display().to_string(),
                &std::io::ErrorKind::AlreadyExists.into(),
            )),
            Err(_) => Ok(()),
        }
    }

    fn changes(&self) -> Result<Vec<LevelChange>, Failure> {
        self.levels.iter().map(|change| settings::parse(change)).collect()
    }

    fn handled(&self, dictionary: &ir::Dictionary) -> Result<Vec<Selector>, Failure> {
        if self.handle.is_empty() {
            return Ok(scaffold::object_to_handle(dictionary).into_iter().collect());
        }
        self.handle.iter().map(|text| selector(text)).collect()
    }

    /// The copy's name.
    fn file_name(&self, package: &str) -> String {
        match (Input::new(&self.eds), self.eds.file_name()) {
            (Input::File(_), Some(name)) => name.to_string_lossy().into_owned(),
            _ => format!("{package}.eds"),
        }
    }

    fn node_id(&self, dictionary: &ir::Dictionary) -> u8 {
        let commissioned = || dictionary.commissioning.as_ref()?.node_id;
        let node_id = self.node_id.or_else(|| Some(commissioned()?.get()));
        node_id.unwrap_or(1)
    }

    /// The dependency on one of our crates as TOML: a version, or a path and a version.
    fn dependency(&self, folder: &str) -> Result<String, Failure> {
        const VERSION: &str = env!("CARGO_PKG_VERSION");
        let Some(checkout) = &self.checkout else {
            return Ok(format!("\"{VERSION}\""));
        };
        let path = checkout.join(folder);
        if !path.join("Cargo.toml").is_file() {
            let checkout = checkout.display();
            return Err(Failure::new(format!(
                "--checkout {checkout}: there is no {folder}/Cargo.toml in it; name the folder that Lexican was checked out to"
            )));
        }
        let path = path
            .canonicalize()
            .map_err(|error| Failure::io("cannot look into", &path.display().to_string(), &error))?;
        Ok(format!("{{ path = '{}', version = \"{VERSION}\" }}", path.display()))
    }

    fn write(&self, scaffold: &Scaffold<'_>, generated: &Generated, eds: &[u8]) -> Result<(), Failure> {
        let texts = scaffold
            .files(generated)
            .map_err(|error| Failure::new(error.to_string()))?;
        let mut files: Vec<(&str, &[u8])> = texts.iter().map(|(path, text)| (*path, text.as_bytes())).collect();
        files.push((scaffold.eds, eds));
        output::write_folder(&self.path, &files)?;
        note(&format!(
            "{} is a firmware crate; `cargo test` in it, and its README.md says what is where",
            self.path.display()
        ));
        Ok(())
    }
}

fn generate(eds: &str, bytes: &[u8], levels: Levels, handled: &[Selector]) -> Result<Generated, Failure> {
    Builder::from_bytes(eds, bytes)
        .levels(levels)
        .handle(handled.iter().copied())
        .module_name("device")
        .generate()
        .map_err(|error| failure(&error))
}

/// The name of the crate that is to be at `path`, when Cargo takes it.
fn package(path: &Path) -> Result<&str, Failure> {
    let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    match fault(name) {
        None => Ok(name),
        Some(fault) => Err(Failure::new(format!(
            "`{name}` cannot be a crate's name: {fault}; take another one"
        ))),
    }
}

fn fault(name: &str) -> Option<&'static str> {
    let is_taken = |taken: &[&str]| taken.contains(&name.replace('-', "_").as_str());
    let mut letters = name.chars();
    if !letters.next().is_some_and(|first| first.is_ascii_alphabetic()) {
        return Some("it does not start with a letter from a to z");
    }
    if !letters.all(|letter| letter.is_ascii_alphanumeric() || matches!(letter, '-' | '_')) {
        return Some("it has something else in it than letters from a to z, digits, `-` and `_`");
    }
    if is_taken(&KEYWORDS) {
        return Some("it is a keyword of Rust");
    }
    is_taken(&CRATES).then_some("Cargo or the crate itself has something else of this name")
}

/// The words that are no identifiers in any edition (The Rust Reference, "Keywords").
const KEYWORDS: [&str; 52] = [
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do", "dyn", "else",
    "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "match", "mod",
    "move", "mut", "override", "priv", "pub", "ref", "return", "self", "Self", "static", "struct", "super", "trait",
    "true", "try", "type", "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

const CRATES: [&str; 12] = [
    "alloc",
    "build",
    "core",
    "deps",
    "device",
    "examples",
    "handlers",
    "incremental",
    "lexican_codegen",
    "lexican_runtime",
    "std",
    "test",
];
