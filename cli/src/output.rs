//! Standard output, whose reader may leave, and files that appear whole or not at all.

use std::{
    fs,
    io::{self, BufWriter, ErrorKind, Write},
    path::Path,
};

use anstream::AutoStream;

use crate::failure::Failure;

/// Standard output. That its reader leaves, as in `lexican … | head`, is no error.
pub(crate) struct Stdout(BufWriter<Box<dyn Write>>);

impl Stdout {
    /// For people: escape sequences get through where they are wanted.
    pub(crate) fn styled() -> Self {
        Self(BufWriter::new(Box::new(AutoStream::auto(io::stdout()).lock())))
    }

    /// For programs: everything gets through as it is.
    pub(crate) fn plain() -> Self {
        Self(BufWriter::new(Box::new(io::stdout().lock())))
    }

    /// Writes `text`, and all that is still held back.
    pub(crate) fn print(mut self, text: &str) -> Result<(), Failure> {
        self.write_all(text.as_bytes()).map_err(|error| unwritten(&error))?;
        self.finish()
    }

    /// Writes `bytes`, and all that is still held back.
    pub(crate) fn print_bytes(mut self, bytes: &[u8]) -> Result<(), Failure> {
        self.write_all(bytes).map_err(|error| unwritten(&error))?;
        self.finish()
    }

    /// Writes what is still held back.
    pub(crate) fn finish(mut self) -> Result<(), Failure> {
        self.flush().map_err(|error| unwritten(&error))
    }
}

impl Write for Stdout {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        unless_gone(self.0.write(bytes), bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        unless_gone(self.0.flush(), ())
    }
}

/// A reader that left has seen what it wanted.
fn unless_gone<T>(result: io::Result<T>, done: T) -> io::Result<T> {
    match result {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(done),
        result => result,
    }
}

pub(crate) fn unwritten(error: &io::Error) -> Failure {
    Failure::io("cannot write to", "standard output", error)
}

/// Puts `bytes` at `path`, which is a file with other bytes, as [`write()`] does.
pub(crate) fn rewrite(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    replace(path, bytes).map_err(|error| Failure::io("cannot write", &path.display().to_string(), &error))
}

/// Puts `text` at `path` in one step: a reader finds the old file or the new one, never a part. `-` is standard output.
pub(crate) fn write(path: &Path, text: &str) -> Result<(), Failure> {
    if path == Path::new("-") {
        return Stdout::plain().print(text);
    }
    replace(path, text.as_bytes()).map_err(|error| Failure::io("cannot write", &path.display().to_string(), &error))
}

fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    // A link stays a link: what it points to is replaced.
    let path = &path.canonicalize().unwrap_or_else(|_| path.to_owned());
    match fs::metadata(path) {
        Ok(target) if target.is_dir() => return Err(ErrorKind::IsADirectory.into()),
        Ok(target) if !target.is_file() => return fs::write(path, bytes),
        Ok(target) if target.permissions().readonly() => return Err(ErrorKind::PermissionDenied.into()),
        _ => {}
    }
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let mut file = temporary().tempfile_in(folder.unwrap_or(Path::new(".")))?;
    file.write_all(bytes)?;
    if let Ok(old) = fs::metadata(path) {
        file.as_file().set_permissions(old.permissions())?;
    }
    file.persist(path)?;
    Ok(())
}

/// Makes the folder `path` with these files in it, in one step: it is there whole or not at all, and never in the place of
/// another.
pub(crate) fn write_folder(path: &Path, files: &[(&str, &[u8])]) -> Result<(), Failure> {
    let written = create_folder(path, files);
    written.map_err(|error| Failure::io("cannot make", &path.display().to_string(), &error))
}

fn create_folder(path: &Path, files: &[(&str, &[u8])]) -> io::Result<()> {
    let beside = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let scratch = tempfile::Builder::new()
        .prefix(".lexican-")
        .tempdir_in(beside.unwrap_or(Path::new(".")))?;
    // Inside the scratch folder, which nobody else may look into; this one is as readable as any.
    let folder = scratch.path().join("crate");
    for (name, content) in files {
        let file = folder.join(name);
        fs::create_dir_all(file.parent().unwrap_or(&folder))?;
        fs::write(file, content)?;
    }
    if path.symlink_metadata().is_ok() {
        return Err(ErrorKind::AlreadyExists.into());
    }
    fs::rename(folder, path)
}

/// As readable as any new file: the user's mask decides.
#[cfg(unix)]
fn temporary() -> tempfile::Builder<'static, 'static> {
    use std::os::unix::fs::PermissionsExt as _;
    let mut builder = tempfile::Builder::new();
    builder
        .prefix(".lexican-")
        .permissions(fs::Permissions::from_mode(0o666));
    builder
}

#[cfg(not(unix))]
fn temporary() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".lexican-");
    builder
}
