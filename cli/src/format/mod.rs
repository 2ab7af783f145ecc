//! How findings are printed: one format a file.
//!
//! A file's findings become text on the thread that checked it, so that the file itself need not be kept until the end of
//! the run; the [`Printer`] puts the texts together.

mod counts;
mod github;
mod html;
mod json;
mod junit;
mod place;
mod printer;
mod sarif;
mod text;

use std::collections::BTreeSet;

use clap::ValueEnum;
use lexican_eds::{
    diagnostic::{Code, Diagnostic},
    document::Document,
    source::Source,
};

pub(crate) use counts::Counts;
pub(crate) use printer::{Printer, Rendered, Style};

use crate::failure::Failure;

/// An output format.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For people: the line, a caret under the value, the cure
    #[default]
    Text,
    /// For programs, as docs/json.md of the repository describes it
    Json,
    /// For code scanning services: SARIF 2.1.0
    Sarif,
    /// For the test reports of CI services: JUnit XML, a suite a file
    Junit,
    /// For GitHub Actions: annotations in the files of a pull request
    Github,
    /// For a browser: one page with everything in it, to be searched, mailed and archived
    Html,
}

/// What was checked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Subject {
    #[default]
    File,
    /// A device, against its file.
    Device,
}

/// A file, and of what is wrong with it that which is to be shown.
struct Checked<'a> {
    document: &'a Document,
    source: &'a Source,
    findings: &'a [Diagnostic],
}

/// What a run came to.
#[derive(Debug, Default)]
struct Run {
    subject: Subject,
    /// How many were checked.
    files: usize,
    /// Of what is shown.
    counts: Counts,
    /// How many findings are below the level that is shown.
    hidden: usize,
    /// How many of those that are shown have a safe cure.
    fixable: usize,
    /// How many findings were cured.
    fixed: usize,
    /// The rules that found something to show.
    codes: BTreeSet<Code>,
    /// Files and directories that could not be read.
    failures: Vec<Failure>,
}

/// A format: a run is `begin`, the files with `between` between those that are not empty, and `end`.
trait Form: Sync {
    fn begin(&self) -> String {
        String::new()
    }

    fn file(&self, checked: &Checked) -> String;

    fn between(&self) -> &'static str {
        ""
    }

    fn end(&self, run: &Run) -> String;
}

impl Format {
    fn form(self) -> &'static dyn Form {
        match self {
            Self::Text => &text::Text,
            Self::Json => &json::Json,
            Self::Sarif => &sarif::Sarif,
            Self::Junit => &junit::Junit,
            Self::Github => &github::Github,
            Self::Html => &html::Html,
        }
    }

    /// Whether it speaks to people, who like colours, and not to programs.
    fn is_for_people(self) -> bool {
        self == Self::Text
    }
}

/// `value` as JSON, `depth` levels deep in a document that is indented by two blanks a level.
fn json_within(value: &impl serde::Serialize, depth: usize) -> String {
    // Only maps whose keys are no strings cannot be written, and there is none.
    let text = serde_json::to_string_pretty(value).unwrap_or_default();
    // A line feed in a string is written as `\n`, so that each one here is between two tokens.
    text.replace('\n', &format!("\n{}", "  ".repeat(depth)))
}
