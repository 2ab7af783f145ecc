//! Why nothing was generated.

use std::{error, fmt, io, path::PathBuf};

use lexican_eds::rules::UnknownRule;

use crate::Selector;

/// Why nothing was generated or written.
///
/// Its `Debug` form is what Cargo shows when a build script's `main` returns it, so that is for people too.
#[non_exhaustive]
pub enum Error {
    /// The file cannot be read.
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A rule denies the file.
    Refused {
        /// The file.
        file: String,
        /// The diagnostics, as `lexican check` shows them.
        diagnostics: Vec<String>,
    },
    /// The builder names a rule that does not exist.
    UnknownRule(UnknownRule),
    /// The builder names an object that is not in the file.
    NoSuchObject {
        /// What the builder names.
        selector: Selector,
        /// The file.
        file: String,
        /// What is in the file nearby.
        near: Vec<String>,
    },
    /// The builder has the application answer for reading what a client cannot read.
    NotReadable {
        /// What the builder names.
        selector: Selector,
        /// The file.
        file: String,
    },
    /// The builder has the application answer for writing what a client cannot write.
    NotWritable {
        /// What the builder names.
        selector: Selector,
        /// The file.
        file: String,
    },
    /// The builder gives a capacity to something that is no string.
    NotAString {
        /// What the builder names.
        selector: Selector,
        /// The file.
        file: String,
    },
    /// The builder has the application give in parts what is no string.
    NotStreamed {
        /// What the builder names.
        selector: Selector,
        /// The file.
        file: String,
    },
    /// The dictionary is beyond the 65,536 bytes that its table reaches.
    TooLarge {
        /// The file.
        file: String,
        /// Bytes of the values.
        values: usize,
        /// Bytes of the constants.
        constants: usize,
    },
    /// OUT_DIR is not set: this is no build script.
    NoOutDir,
    /// The generated file cannot be written.
    Write {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A template cannot be rendered.
    #[cfg(feature = "templates")]
    Template(lexican_templates::Error),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Read { path, source } => write!(f, "cannot read {}: {source}", path.display()),
            Self::Refused { file, diagnostics } => {
                let errors = if diagnostics.len() == 1 { "an error" } else { "errors" };
                write!(
                    f,
                    "{file} has {errors}, so no code is generated\n\n{}",
                    diagnostics.join("\n")
                )
            }
            Self::UnknownRule(rule) => rule.fmt(f),
            Self::NoSuchObject { selector, file, near } => {
                write!(f, "{selector} is not in {file}")?;
                if near.is_empty() {
                    Ok(())
                } else {
                    write!(f, "; near it are {}", near.join(", "))
                }
            }
            Self::NotReadable { selector, file } => {
                write!(f, "{selector} of {file} cannot be read, so there is nothing to handle")
            }
            Self::NotWritable { selector, file } => {
                write!(
                    f,
                    "{selector} of {file} cannot be written, so there is nothing to handle"
                )
            }
            Self::NotAString { selector, file } => {
                write!(f, "{selector} of {file} is no string, so it has no capacity")
            }
            Self::NotStreamed { selector, file } => {
                write!(f, "{selector} of {file} is no string, so it does not go in parts")
            }
            Self::TooLarge {
                file,
                values,
                constants,
            } => write!(
                f,
                "{file} is too large: {values} bytes of values and {constants} of constants, while a table reaches \
                 65536 of each; give strings less room with `capacity`"
            ),
            Self::NoOutDir => f.write_str("OUT_DIR is not set; `write_to_out_dir` is for build scripts"),
            Self::Write { path, source } => write!(f, "cannot write {}: {source}", path.display()),
            #[cfg(feature = "templates")]
            Self::Template(error) => error.fmt(f),
        }
    }
}

impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl error::Error for Error {
    fn source(&self) -> Option<&(dyn error::Error + 'static)> {
        match self {
            Self::Read { source, .. } | Self::Write { source, .. } => Some(source),
            _ => None,
        }
    }
}
