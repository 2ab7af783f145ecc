//! For programs. `docs/json.md` promises this form; [`VERSION`] counts what would break a reader.

use std::io::{self, Write};

use lexican_eds::{diagnostic::Diagnostic, rules, source::Source, span::Span};
use serde::Serialize;

use super::{Checked, Counts, Report};

const VERSION: u32 = 1;

#[derive(Serialize)]
struct Root<'a> {
    format: &'static str,
    version: u32,
    tool: &'static str,
    files: Vec<File<'a>>,
    failures: Vec<String>,
    summary: Summary,
}

#[derive(Serialize)]
struct File<'a> {
    path: &'a str,
    findings: Vec<Finding<'a>>,
}

#[derive(Serialize)]
struct Finding<'a> {
    code: &'static str,
    rule: String,
    level: &'static str,
    message: &'a str,
    section: Option<&'a str>,
    place: Option<Place>,
    label: Option<&'a str>,
    related: Vec<Related<'a>>,
    help: Option<&'a str>,
}

#[derive(Serialize)]
struct Related<'a> {
    place: Place,
    label: &'a str,
}

/// Lines and columns count from 1, columns in characters; `end_column` is that of the character behind the last.
#[derive(Serialize)]
struct Place {
    line: u32,
    column: u32,
    end_column: u32,
}

#[derive(Serialize)]
struct Summary {
    files: usize,
    #[serde(flatten)]
    counts: Counts,
}

/// Writes one JSON object.
pub(super) fn write(report: &Report, out: &mut impl Write) -> io::Result<()> {
    let root = Root {
        format: "lexican-check",
        version: VERSION,
        tool: concat!("lexican ", env!("CARGO_PKG_VERSION")),
        files: report.checked.iter().map(file).collect(),
        failures: report.failures.iter().map(ToString::to_string).collect(),
        summary: Summary {
            files: report.checked.len(),
            counts: report.counts(),
        },
    };
    serde_json::to_writer_pretty(&mut *out, &root)?;
    writeln!(out)
}

fn file(checked: &Checked) -> File<'_> {
    let source = checked.document.source();
    let diagnostics = checked.diagnostics.iter();
    File {
        path: source.name(),
        findings: diagnostics.map(|diagnostic| finding(source, diagnostic)).collect(),
    }
}

fn finding<'a>(source: &'a Source, diagnostic: &'a Diagnostic) -> Finding<'a> {
    let related = diagnostic.related.iter().map(|related| Related {
        place: place(source, related.span),
        label: &related.label,
    });
    Finding {
        code: diagnostic.code.as_str(),
        rule: rules::find(diagnostic.code.as_str()).map_or_else(String::new, rules::Rule::name),
        level: diagnostic.level.name(),
        message: &diagnostic.message,
        section: diagnostic.section.map(|header| source.slice(header)),
        place: (!diagnostic.about_file()).then(|| place(source, diagnostic.span)),
        label: diagnostic.label.as_deref(),
        related: related.collect(),
        help: diagnostic.help.as_deref(),
    }
}

fn place(source: &Source, span: Span) -> Place {
    let start = source.line_column(span);
    let end = source.line_column(Span::new(span.end, span.end));
    Place {
        line: start.line,
        column: start.column,
        end_column: end.column,
    }
}
