//! Files to read, and `-` for standard input.

use std::{
    fs,
    io::{self, Read as _},
    path::{Path, PathBuf},
};

use walkdir::{DirEntry, WalkDir};

use crate::failure::Failure;

/// Something to read from.
#[derive(Clone, Debug)]
pub(crate) enum Input {
    Stdin,
    File(PathBuf),
}

impl Input {
    /// The file at `path`; standard input for `-`.
    pub(crate) fn new(path: &Path) -> Self {
        if path == Path::new("-") {
            Self::Stdin
        } else {
            Self::File(path.to_owned())
        }
    }

    /// What messages call it.
    pub(crate) fn name(&self) -> String {
        match self {
            Self::Stdin => "<stdin>".into(),
            Self::File(path) => path.display().to_string(),
        }
    }

    pub(crate) fn read(&self) -> Result<Vec<u8>, Failure> {
        let bytes = match self {
            Self::Stdin => read_stdin(),
            Self::File(path) => fs::read(path),
        };
        bytes.map_err(|error| Failure::io("cannot read", &self.name(), &error))
    }

    pub(crate) fn read_text(&self) -> Result<String, Failure> {
        let text = String::from_utf8(self.read()?);
        text.map_err(|_| Failure::new(format!("cannot read {}: it is not UTF-8 text", self.name())))
    }
}

fn read_stdin() -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    io::stdin().lock().read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// What `path` stands for: itself, or the EDS and DCF files in it and below, by name. What is below `.` is called without it, as
/// the editors and services that read our output call it.
pub(crate) fn expand(path: &Path) -> Result<Vec<Input>, Failure> {
    if !path.is_dir() {
        return Ok(vec![Input::new(path)]);
    }
    let mut files = Vec::new();
    for entry in WalkDir::new(path).follow_links(true).sort_by_file_name() {
        let entry = entry.map_err(|error| unwalkable(path, &error))?;
        if is_description(&entry) {
            let path = entry.path();
            files.push(Input::File(path.strip_prefix(".").unwrap_or(path).to_owned()));
        }
    }
    if files.is_empty() {
        let path = path.display();
        return Err(Failure::new(format!(
            "no .eds or .dcf file in {path}; name the file itself"
        )));
    }
    Ok(files)
}

fn is_description(entry: &DirEntry) -> bool {
    let extension = entry.path().extension().unwrap_or_default();
    entry.file_type().is_file() && ["eds", "dcf"].iter().any(|known| extension.eq_ignore_ascii_case(known))
}

fn unwalkable(root: &Path, error: &walkdir::Error) -> Failure {
    let path = error.path().unwrap_or(root).display().to_string();
    match error.io_error() {
        Some(error) => Failure::io("cannot look into", &path, error),
        None => Failure::new(format!("{path} links back to a directory above it")),
    }
}
