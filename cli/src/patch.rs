//! What changes in a file, as a unified diff.

use std::io::{IsTerminal as _, Write as _};

use anstream::{AutoStream, ColorChoice};
use anstyle::{AnsiColor, Style};
use lexican_eds::{render::printable, source::Source};
use similar::{ChangeTag, TextDiff};

/// Who reads the diff.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reader {
    /// `patch` and its like: the bytes of the file, in whatever encoding.
    Program,
    /// Somebody at a terminal: the text, nothing in it steers the terminal, with escape sequences for colours.
    Person,
}

impl Reader {
    /// Who reads standard output.
    pub(crate) fn of_stdout() -> Self {
        let stdout = std::io::stdout();
        let coloured = AutoStream::choice(&stdout) != ColorChoice::Never;
        if coloured || stdout.is_terminal() {
            Self::Person
        } else {
            Self::Program
        }
    }
}

/// The diff from `old` to `new`; empty when they are the same.
pub(crate) fn unified(old: &Source, new: &Source, reader: Reader) -> Vec<u8> {
    match reader {
        Reader::Program => exact(old.name(), &old.to_bytes(), &new.to_bytes()),
        Reader::Person => coloured(old, new).into_bytes(),
    }
}

/// As [`similar`] writes a diff of text, but byte by byte.
fn exact(name: &str, old: &[u8], new: &[u8]) -> Vec<u8> {
    let name = printable(name);
    let diff = TextDiff::from_lines(old, new);
    let mut text = Vec::new();
    for (number, hunk) in diff.unified_diff().iter_hunks().enumerate() {
        if number == 0 {
            text.extend(format!("--- {name}\n+++ {name}\n").into_bytes());
        }
        text.extend(format!("{}\n", hunk.header().to_string().trim_end()).into_bytes());
        for change in hunk.iter_changes() {
            text.extend(change.tag().to_string().into_bytes());
            text.extend(change.value());
            if change.missing_newline() {
                text.extend(b"\n\\ No newline at end of file\n");
            }
        }
    }
    text
}

fn coloured(old: &Source, new: &Source) -> String {
    let (old_text, new_text) = (marked(old), marked(new));
    let diff = TextDiff::from_lines(old_text.as_str(), new_text.as_str());
    let ends = ends(&old_text);
    let name = printable(old.name());
    let bold = Style::new().bold();
    let mut text = Vec::new();
    for (number, hunk) in diff.unified_diff().iter_hunks().enumerate() {
        if number == 0 {
            let _ = writeln!(text, "{bold}--- {name}{bold:#}\n{bold}+++ {name}{bold:#}");
        }
        let cyan = AnsiColor::Cyan.on_default();
        let _ = writeln!(text, "{cyan}{}{cyan:#}", hunk.header().to_string().trim_end());
        for change in hunk.iter_changes() {
            let (sign, style) = match change.tag() {
                ChangeTag::Equal => (' ', Style::new()),
                ChangeTag::Delete => ('-', AnsiColor::Red.on_default()),
                ChangeTag::Insert => ('+', AnsiColor::Green.on_default()),
            };
            let line = change.value();
            let line = printable(line.strip_suffix(ends).unwrap_or(line));
            let _ = writeln!(text, "{style}{sign}{line}{style:#}");
        }
    }
    String::from_utf8_lossy(&text).into_owned()
}

/// The text with its byte order mark.
fn marked(source: &Source) -> String {
    let mark = if source.byte_order_mark() { "\u{FEFF}" } else { "" };
    format!("{mark}{}", source.text())
}

/// What ends every line. Where lines end differently, only what all of them have is left out, so that the rest is seen.
fn ends(text: &str) -> &'static str {
    let all_dos = text
        .split_inclusive('\n')
        .all(|line| line.ends_with("\r\n") || !line.ends_with('\n'));
    if all_dos { "\r\n" } else { "\n" }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn source(text: &[u8]) -> Source {
        Source::decode("a.eds", text.to_vec())
    }

    #[test]
    fn a_program_gets_the_bytes_of_the_file() {
        let diff = unified(
            &source(b"[1000]\r\nParameterName=\xE4\r\n"),
            &source(b"[1000]\r\nParameterName=a\r\n"),
            Reader::Program,
        );
        let expected = b"--- a.eds\n+++ a.eds\n@@ -1,2 +1,2 @@\n [1000]\r\n-ParameterName=\xE4\r\n+ParameterName=a\r\n";
        assert_eq!(diff, expected);
    }

    #[test]
    fn a_person_sees_nothing_that_steers_the_terminal_and_which_line_ends_change() {
        let diff = unified(
            &source(b"a=\x1B[2J\r\nb=1\n"),
            &source(b"a=\x1B[2J\r\nb=1\r\n"),
            Reader::Person,
        );
        let text = anstream::adapter::strip_str(std::str::from_utf8(&diff).unwrap()).to_string();
        assert!(
            text.contains("-b=1\n+b=1\u{240D}\n") && !text.contains("\x1B[2J"),
            "{text:?}"
        );
    }

    #[test]
    fn what_is_the_same_has_no_diff() {
        for reader in [Reader::Program, Reader::Person] {
            assert!(unified(&source(b"a=1\n"), &source(b"a=1\n"), reader).is_empty());
        }
    }
}
