//! What was generated, and writing it.

use std::{
    env, fs,
    path::{Path, PathBuf},
};

use lexican_eds::ir::Dictionary;

use crate::{
    Error, check, emit,
    plan::{Options, Plan},
};

/// So many warnings are shown one by one in a build.
const WARNINGS: usize = 10;

/// Generated code, not written anywhere yet.
#[derive(Clone, Debug)]
pub struct Generated {
    name: String,
    source: String,
    file: String,
    dictionary: Dictionary,
    /// Templates are rendered from the plan, which is made again for them.
    #[cfg(feature = "templates")]
    options: Options,
    path: Option<PathBuf>,
    pub(crate) warnings: Vec<String>,
}

impl Generated {
    pub(crate) fn new(dictionary: Dictionary, file: String, name: String, options: &Options) -> Result<Self, Error> {
        let plan = Plan::new(&dictionary, &file, name.clone(), options);
        check::size(&plan)?;
        let source = emit::source(&plan);
        Ok(Self {
            name,
            source,
            file,
            dictionary,
            #[cfg(feature = "templates")]
            options: options.clone(),
            path: None,
            warnings: Vec::new(),
        })
    }

    /// Remembers which file the build depends on.
    pub(crate) fn of_file(mut self, path: PathBuf) -> Self {
        self.path = Some(path);
        self
    }

    /// The module's name, which is also its file's: `wdga` for `wdga.rs`.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The Rust source: one item, `pub mod <name>`, for `include!`.
    #[must_use]
    pub fn source(&self) -> &str {
        &self.source
    }

    /// What the rules found below [`Level::Deny`](lexican_eds::diagnostic::Level::Deny), a line each.
    #[must_use]
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// The dictionary that the code was generated from.
    #[must_use]
    pub fn dictionary(&self) -> &Dictionary {
        &self.dictionary
    }

    /// Writes the source to `<name>.rs` in Cargo's OUT_DIR, whole or not at all, and tells Cargo what it depends on.
    ///
    /// ```ignore
    /// include!(concat!(env!("OUT_DIR"), "/wdga.rs"));
    /// ```
    ///
    /// # Errors
    /// Outside a build script, and when the file cannot be written.
    pub fn write_to_out_dir(&self) -> Result<(), Error> {
        let folder = env::var_os("OUT_DIR").map(PathBuf::from).ok_or(Error::NoOutDir)?;
        let path = folder.join(&self.name).with_extension("rs");
        replace(&path, &self.source).map_err(|source| Error::Write { path, source })?;
        self.tell_cargo();
        Ok(())
    }

    #[expect(
        clippy::print_stdout,
        reason = "a build script speaks to Cargo on its standard output"
    )]
    fn tell_cargo(&self) {
        if let Some(path) = &self.path {
            println!("cargo::rerun-if-changed={}", path.display());
        }
        for warning in self.warnings.iter().take(WARNINGS) {
            println!("cargo::warning={warning}");
        }
        if let Some(more @ 1..) = self.warnings.len().checked_sub(WARNINGS) {
            println!(
                "cargo::warning={more} more findings; `lexican check {}` shows them all",
                self.file
            );
        }
    }

    /// The plan that the source was made by.
    #[cfg(feature = "templates")]
    pub(crate) fn plan(&self) -> Plan<'_> {
        Plan::new(&self.dictionary, &self.file, self.name.clone(), &self.options)
    }
}

/// Puts `text` into the file at `path`; whoever reads it meanwhile sees the old file or the new one, never a part.
fn replace(path: &Path, text: &str) -> std::io::Result<()> {
    let new = path.with_extension("rs.new");
    fs::write(&new, text)?;
    fs::rename(&new, path)
}
