//! Why a command could not run: what, where, what to do; one line.

use std::{
    fmt,
    io::{self, ErrorKind, Write as _},
};

/// A sentence for stderr. Nothing in it steers the terminal.
#[derive(Debug)]
pub(crate) struct Failure(String);

impl Failure {
    pub(crate) fn new(sentence: impl Into<String>) -> Self {
        Self(sentence.into())
    }

    /// `action` (`cannot read`) on `what` did not work.
    pub(crate) fn io(action: &str, what: &str, error: &io::Error) -> Self {
        Self(format!("{action} {what}: {}", reason(error)))
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&lexican_eds::render::printable(&self.0))
    }
}

/// Tells the user what the command does not fail by, on stderr. Nobody is left to hear of it when stderr is gone.
pub(crate) fn note(sentence: &str) {
    let style = anstyle::AnsiColor::BrightGreen.on_default().bold();
    let sentence = lexican_eds::render::printable(sentence);
    let _ = writeln!(anstream::stderr(), "{style}note{style:#}: {sentence}");
}

/// What the system says, without its numbers, and the cure where there is one.
fn reason(error: &io::Error) -> String {
    match error.kind() {
        ErrorKind::NotFound => "there is no such file or directory".into(),
        ErrorKind::PermissionDenied => "permission denied".into(),
        ErrorKind::IsADirectory => "it is a directory; name a file".into(),
        ErrorKind::NotADirectory => "a part of the path is a file, not a directory".into(),
        ErrorKind::AlreadyExists => "it is there already; take another name, or remove it".into(),
        ErrorKind::StorageFull => "the disk is full".into(),
        _ => error.to_string(),
    }
}
