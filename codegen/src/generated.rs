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

    /// What the rules found at [`Level::Warn`](lexican_eds::diagnostic::Level::Warn), a line each.
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
    /// `include!(concat!(env!("OUT_DIR"), "/wdga.rs"));` takes it into the crate.
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

    /// A skeleton of `Handlers` that compiles, to start an application from.
    ///
    /// # Errors
    /// None that a file could be the reason of.
    #[cfg(feature = "templates")]
    pub fn stubs(&self) -> Result<String, Error> {
        self.render(&lexican_templates::STUBS)
    }

    /// The dictionary as Markdown: its objects, and its PDOs.
    ///
    /// # Errors
    /// None that a file could be the reason of.
    #[cfg(feature = "templates")]
    pub fn docs(&self) -> Result<String, Error> {
        self.render(&lexican_templates::DOCS)
    }

    /// Fills a template of the user's own. What it has to fill in:
    ///
    /// | name | is |
    /// |---|---|
    /// | `module` | the generated module's name |
    /// | `file` | `name`, `version`, `revision`, `eds_version`, `description` |
    /// | `device` | the keywords of `[DeviceInfo]`, as the fields of [`DeviceInfo`](lexican_eds::ir::DeviceInfo) are named; `baud_rates` in kbit/s |
    /// | `commissioning` | those of `[DeviceComissioning]`; none without that section |
    /// | `objects` | a list of: `index`, `name`, `code` (`VAR`), `list` (`mandatory`), `links`, `entries` |
    /// | … `.entries` | a list of: `index`, `sub`, `name`, `data_type` (`UNSIGNED32`), `bits`, `access` (`rw`), `readable`, `writable`, `pdo_mapping`, `pdo` (`T`, `R`, `TR`), `default`, `configured`, `low`, `high`, `limits`, `unit`, `denotation`, `refuse_write_on_download`, `refuse_read_on_scan`, `upload_file`, `download_file`, `rust_name`, `is_constant`, `capacity` |
    /// | `areas` | the same objects in a list of: `title` (`Communication`), `objects` |
    /// | `pdos` | a list of: `direction` (`TPDO`), `number`, `cob_id`, `transmission_type`, `inhibit_time`, `event_timer`, `bits`, `mapped` |
    /// | … `.mapped` | a list of: `index`, `sub`, `bits`, `name` |
    /// | `handlers` | a list of: `method`, `about`, `index`, `subs`, `parameters`, `returns`, `body` (which gives the stored value) |
    /// | `imports` | the runtime's types that `handlers` name |
    ///
    /// Indices, sub-indices and other counts are numbers; `default`, `low`, `high` and the PDOs' parameters are texts. What
    /// the file does not give is `none`.
    ///
    /// # Errors
    /// When the template is not one, or asks for what is not there.
    #[cfg(feature = "templates")]
    pub fn render(&self, template: &lexican_templates::Template<'_>) -> Result<String, Error> {
        template.render(self.context()).map_err(Error::Template)
    }

    /// What a template has to fill in, to be filled into one together with something else; [`Generated::render`] lists it.
    #[cfg(feature = "templates")]
    #[must_use]
    pub fn context(&self) -> lexican_templates::Value {
        let plan = Plan::new(&self.dictionary, &self.file, self.name.clone(), &self.options);
        crate::view::context(&plan)
    }
}

/// Puts `text` into the file at `path`; whoever reads it meanwhile sees the old file or the new one, never a part.
fn replace(path: &Path, text: &str) -> std::io::Result<()> {
    let new = path.with_extension("rs.new");
    fs::write(&new, text)?;
    fs::rename(&new, path)
}
