//! From a file to Rust, step by step.

use std::{fs, path::PathBuf};

use lexican_eds::{
    Reading,
    diagnostic::{Diagnostic, Level},
    ir::Dictionary,
    render::Renderer,
    rules::{self, LevelChange, Levels},
};

use crate::{
    Error, Generated, Selector, check,
    name::{field_ident, letter_first, snake},
    plan::Options,
};

/// What is to be generated from a file, and how.
///
/// ```no_run
/// fn main() -> Result<(), lexican_codegen::Error> {
///     lexican_codegen::Builder::new("wdga.eds")
///         .handle([0x6003, 0x6004])
///         .capacity(0x100A, 16)
///         .generate()?
///         .write_to_out_dir()
/// }
/// ```
#[derive(Clone, Debug)]
#[must_use = "a builder does nothing before `generate`"]
pub struct Builder {
    input: Input,
    module_name: Option<String>,
    base: Levels,
    levels: Vec<(String, Level)>,
    options: Options,
}

#[derive(Clone, Debug)]
enum Input {
    File(PathBuf),
    Bytes { name: String, bytes: Vec<u8> },
}

impl Builder {
    /// Compiles the EDS or DCF file at `path`; in a build script a relative one starts at the package's root.
    pub fn new(path: impl Into<PathBuf>) -> Self {
        Self::from_input(Input::File(path.into()))
    }

    /// Compiles a file that was read already; `name` is what messages and documentation call it.
    pub fn from_bytes(name: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Self {
        let (name, bytes) = (name.into(), bytes.into());
        Self::from_input(Input::Bytes { name, bytes })
    }

    fn from_input(input: Input) -> Self {
        Self {
            input,
            module_name: None,
            base: Levels::default(),
            levels: Vec::new(),
            options: Options::default(),
        }
    }

    /// Has the application answer for these objects: each gets a method in the generated trait `Handlers` for reading,
    /// if clients may read it, and one for writing, if they may write it.
    ///
    /// An index stands for all values of its object, `(index, sub_index)` for one: `.handle([0x6003, 0x6004])`,
    /// `.handle([(0x1010, 1)])`. An object that the file calls constant becomes a field of the dictionary.
    ///
    /// A DOMAIN that is handled in any way may have any length, as the dictionary has no room for it: the application gives
    /// and takes it in parts, as many bytes at a time as [`Builder::capacity`] says, in all directions that clients have.
    pub fn handle<S: Into<Selector>>(mut self, objects: impl IntoIterator<Item = S>) -> Self {
        let objects: Vec<Selector> = objects.into_iter().map(Into::into).collect();
        self.options.reads.extend(&objects);
        self.options.writes.extend(&objects);
        self
    }

    /// As [`Builder::handle`], but only when a client reads them; what it writes is stored without asking.
    pub fn handle_reads<S: Into<Selector>>(mut self, objects: impl IntoIterator<Item = S>) -> Self {
        self.options.reads.extend(objects.into_iter().map(Into::into));
        self
    }

    /// As [`Builder::handle`], but only when a client writes them; what it reads is the stored value.
    pub fn handle_writes<S: Into<Selector>>(mut self, objects: impl IntoIterator<Item = S>) -> Self {
        self.options.writes.extend(objects.into_iter().map(Into::into));
        self
    }

    /// Has the application give and take these strings in parts, as it does the DOMAINs that it handles: the dictionary has
    /// no room for them, and they may have any length.
    ///
    /// For a text that stands in flash or in a file, or that is made while it is sent. As many bytes go at a time as
    /// [`Builder::capacity`] says; an index stands for all strings of its object. The value that the file gives is not used,
    /// and what goes in parts cannot be stored or put into a PDO.
    pub fn stream<S: Into<Selector>>(mut self, objects: impl IntoIterator<Item = S>) -> Self {
        self.options.streams.extend(objects.into_iter().map(Into::into));
        self
    }

    /// Gives a string or DOMAIN room for `bytes`, 1 to 65,533. An index stands for all strings of its object.
    ///
    /// Without this a string has the room of its default value, or 32 bytes when the file gives it none.
    pub fn capacity(mut self, object: impl Into<Selector>, bytes: u16) -> Self {
        self.options.capacities.push((object.into(), usize::from(bytes)));
        self
    }

    /// Names the generated module and its file; the name is the EDS file's otherwise.
    pub fn module_name(mut self, name: impl Into<String>) -> Self {
        self.module_name = Some(name.into());
        self
    }

    /// Gives a rule (`EDS004`) or a family of rules (`EDS`) another level. What a rule finds at [`Level::Deny`] stops
    /// [`Builder::generate`]; what it finds at [`Level::Warn`] is a warning of the build.
    pub fn level(mut self, rule: impl Into<String>, level: Level) -> Self {
        self.levels.push((rule.into(), level));
        self
    }

    /// Starts from these levels of the rules; [`Builder::level`] changes them.
    pub fn levels(mut self, levels: Levels) -> Self {
        self.base = levels;
        self
    }

    /// Reads the file and generates the code; nothing is written and nothing printed.
    ///
    /// # Errors
    /// When the file cannot be read, when a rule denies it, when the builder names an object that is not in it, or when
    /// the dictionary is too large.
    pub fn generate(self) -> Result<Generated, Error> {
        let levels = self.all_levels()?;
        let (name, bytes) = self.input.read()?;
        let reading = lexican_eds::read(name, bytes);
        let found = rules::check(&reading, &levels);
        refuse_denied(&reading, &found)?;
        let warnings = found.iter().filter(|diagnostic| diagnostic.level == Level::Warn);
        let warnings = warnings.map(|diagnostic| one_line(&reading, diagnostic)).collect();
        let mut generated = self.generate_from(reading.document.source().name(), reading.dictionary)?;
        generated.warnings = warnings;
        Ok(generated)
    }

    /// Generates the code of a dictionary that was read already.
    pub(crate) fn generate_from(self, file: &str, dictionary: Dictionary) -> Result<Generated, Error> {
        check::selectors(&dictionary, file, &self.options)?;
        let name = file_name(file);
        let module = module_name(self.module_name.as_deref(), name);
        let generated = Generated::new(dictionary, name.to_owned(), module, &self.options)?;
        Ok(match self.input {
            Input::File(path) => generated.of_file(path),
            Input::Bytes { .. } => generated,
        })
    }

    fn all_levels(&self) -> Result<Levels, Error> {
        let changes = self
            .levels
            .iter()
            .try_fold(Levels::default(), |levels, (rule, level)| {
                let change = LevelChange::new(rule, *level).map_err(Error::UnknownRule)?;
                Ok(levels.with(change))
            })?;
        Ok(self.base.clone().then(changes))
    }
}

impl Input {
    /// The file's name and its bytes.
    fn read(&self) -> Result<(String, Vec<u8>), Error> {
        match self {
            Self::Bytes { name, bytes } => Ok((name.clone(), bytes.clone())),
            Self::File(path) => {
                let bytes = fs::read(path).map_err(|source| Error::Read {
                    path: path.clone(),
                    source,
                })?;
                Ok((path.display().to_string(), bytes))
            }
        }
    }
}

fn refuse_denied(reading: &Reading, found: &[Diagnostic]) -> Result<(), Error> {
    let source = reading.document.source();
    let denied: Vec<String> = found
        .iter()
        .filter(|diagnostic| diagnostic.level == Level::Deny)
        .map(|diagnostic| Renderer::plain().render(source, diagnostic))
        .collect();
    if denied.is_empty() {
        return Ok(());
    }
    Err(Error::Refused {
        file: source.name().to_owned(),
        diagnostics: denied,
    })
}

/// A finding as Cargo shows a warning of a build script.
fn one_line(reading: &Reading, diagnostic: &Diagnostic) -> String {
    let text = Renderer::plain().render(reading.document.source(), diagnostic);
    text.lines().next().unwrap_or_default().to_owned()
}

/// The file's name without its folder: generated code is the same on every machine.
fn file_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

/// The module's name: what the user says, or the file's name without its extension.
fn module_name(told: Option<&str>, file: &str) -> String {
    let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
    match snake(told.unwrap_or(stem)) {
        name if name.is_empty() => "dictionary".to_owned(),
        name => field_ident(&letter_first(name)),
    }
}

#[cfg(test)]
mod tests {
    use super::{file_name, module_name};

    #[test]
    fn a_module_is_named_after_its_file() {
        assert_eq!(module_name(None, file_name("devices/WDGA-58.eds")), "wdga_58");
        assert_eq!(module_name(None, file_name(r"C:\eds\loop.eds")), "loop_");
        assert_eq!(module_name(None, "4711.eds"), "object_4711");
        assert_eq!(module_name(None, ".eds"), "dictionary");
        assert_eq!(module_name(Some("Encoder"), "wdga.eds"), "encoder");
    }
}
