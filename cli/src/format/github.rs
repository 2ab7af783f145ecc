//! Workflow commands of GitHub Actions: each finding becomes an annotation at its line of the file.
//!
//! GitHub shows at most ten errors, ten warnings and ten notices of a step as annotations; the log of the step has all.

use std::fmt::Write as _;

use lexican_eds::{
    diagnostic::{Diagnostic, Level},
    render::printable,
    source::Source,
};

use super::{Checked, Form, Run, place::Place};

pub(super) struct Github;

impl Form for Github {
    fn file(&self, checked: &Checked) -> String {
        let mut text = String::new();
        for finding in checked.findings {
            let (command, code) = (command(finding.level), finding.code);
            let place = place(checked.source, finding);
            let message = data(&message(finding));
            let _ = writeln!(text, "::{command} {place},title={code}::{message}");
        }
        text
    }

    /// The summary, which is a line of the log, and what could not be read.
    fn end(&self, run: &Run) -> String {
        let mut text = String::new();
        for failure in &run.failures {
            let _ = writeln!(text, "::error title=lexican::{}", data(&failure.to_string()));
        }
        text + &format!("{run}\n")
    }
}

const fn command(level: Level) -> &'static str {
    match level {
        Level::Deny => "error",
        Level::Warn => "warning",
        Level::Note | Level::Allow => "notice",
    }
}

fn message(finding: &Diagnostic) -> String {
    let message = printable(&finding.message);
    match &finding.help {
        Some(help) => format!("{message}\nhelp: {}", printable(help)),
        None => message,
    }
}

/// `file=pump.eds,line=3,col=1,endColumn=9`
fn place(source: &Source, finding: &Diagnostic) -> String {
    let file = property(&printable(&source.name().replace('\\', "/")));
    if finding.about_file() {
        return format!("file={file}");
    }
    let Place {
        line,
        column,
        end_column,
    } = Place::of(source, finding.span);
    format!("file={file},line={line},col={column},endColumn={end_column}")
}

/// A message, as the runner takes it apart.
fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// The value of a property, as the runner takes it apart.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}
