//! Files to read: the corpus of real ones, and made-up ones.

use std::path::PathBuf;
use std::sync::OnceLock;

use lexican_eds::{document::Document, source::Source};

/// A file of the corpus.
pub(crate) struct RealFile {
    pub(crate) name: String,
    pub(crate) bytes: Vec<u8>,
    pub(crate) document: Document,
}

impl RealFile {
    /// Whether its name says EDS or DCF, and not XML.
    pub(crate) fn is_ini(&self) -> bool {
        ![".xdd", ".xdc", ".xpd"]
            .iter()
            .any(|extension| self.name.ends_with(extension))
    }
}

/// The real EDS, DCF and XDD files, read once for all tests.
pub(crate) fn real_files() -> &'static [RealFile] {
    static FILES: OnceLock<Vec<RealFile>> = OnceLock::new();
    FILES.get_or_init(|| corpus("files"))
}

/// The real EDS and DCF files.
pub(crate) fn real_eds() -> impl Iterator<Item = &'static RealFile> {
    real_files().iter().filter(|file| file.is_ini())
}

/// The real files of a folder of the corpus beside the repository; none, with a notice, where it is not.
pub(crate) fn corpus(folder: &str) -> Vec<RealFile> {
    let root: PathBuf = [env!("CARGO_MANIFEST_DIR"), "..", "..", "shared", "corpus", folder]
        .iter()
        .collect();
    let Ok(files) = root.read_dir() else {
        skipped(folder);
        return Vec::new();
    };
    let mut paths: Vec<PathBuf> = files.map(|file| file.unwrap().path()).collect();
    paths.sort();
    let read = |path: PathBuf| {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let bytes = std::fs::read(&path).unwrap();
        let document = Document::read(Source::decode(name.clone(), bytes.clone()));
        RealFile { name, bytes, document }
    };
    paths.into_iter().map(read).collect()
}

#[expect(clippy::print_stderr, reason = "a skipped test says so")]
fn skipped(folder: &str) {
    eprintln!("skipped: the corpus of real files ({folder}) is not beside the repository");
}

pub(crate) fn document(bytes: impl Into<Vec<u8>>) -> Document {
    Document::read(Source::decode("test.eds", bytes.into()))
}

/// Numbers that look random and are the same in each run (xorshift64*).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) const fn new(seed: u64) -> Self {
        Self(seed ^ 0x9E37_79B9_7F4A_7C15)
    }

    /// Below `limit`, which is not 0.
    pub(crate) fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let mixed = self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 32;
        usize::try_from(mixed).unwrap() % limit
    }

    pub(crate) fn byte(&mut self) -> u8 {
        u8::try_from(self.below(256)).unwrap()
    }

    pub(crate) fn pick<'a, T: ?Sized>(&mut self, choices: &[&'a T]) -> &'a T {
        choices[self.below(choices.len())]
    }
}
