//! The real files that some tests read: not part of the project, found beside it or not at all.

use std::fs;
use std::path::{Path, PathBuf};

/// A file of the corpus.
pub struct CorpusFile {
    /// Its name, without folders.
    pub name: String,
    /// Where it is.
    pub path: PathBuf,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

impl CorpusFile {
    /// Whether it is a device description in XML, not an EDS or DCF.
    #[must_use]
    pub fn is_xml(&self) -> bool {
        let extension = self
            .path
            .extension()
            .map(|extension| extension.to_string_lossy().to_lowercase());
        matches!(extension.as_deref(), Some("xdd" | "xdc" | "xpd"))
    }
}

/// The files in `folder` of the corpus, by name; `None`, with a notice, when there is no corpus on this machine.
#[must_use]
pub fn corpus(folder: &str) -> Option<Vec<CorpusFile>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../shared/corpus")
        .join(folder);
    let Ok(entries) = fs::read_dir(&path) else {
        notice(&format!("skipped: no corpus at {}", path.display()));
        return None;
    };
    let mut files: Vec<CorpusFile> = entries.filter_map(|entry| file(entry.ok()?.path())).collect();
    files.sort_by(|one, other| one.name.cmp(&other.name));
    Some(files)
}

fn file(path: PathBuf) -> Option<CorpusFile> {
    let bytes = fs::read(&path).ok()?;
    let name = path.file_name()?.to_string_lossy().into_owned();
    Some(CorpusFile { name, path, bytes })
}

/// Tells whoever runs the tests that one was skipped.
#[expect(clippy::print_stderr, reason = "a skipped test is to be seen")]
pub fn notice(text: &str) {
    eprintln!("{text}");
}
