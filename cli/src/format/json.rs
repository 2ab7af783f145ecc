//! For programs. `docs/json.md` promises this form; [`VERSION`] counts what would break a reader.

use lexican_eds::{diagnostic::Diagnostic, rules, source::Source};
use serde::Serialize;

use super::{Checked, Counts, Form, Run, json_within, place::Place};

const VERSION: u32 = 1;

pub(super) struct Json;

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
    fixable: bool,
}

#[derive(Serialize)]
struct Related<'a> {
    place: Place,
    label: &'a str,
}

#[derive(Serialize)]
struct Summary {
    files: usize,
    #[serde(flatten)]
    counts: Counts,
    hidden: usize,
    fixed: usize,
}

impl Form for Json {
    fn begin(&self) -> String {
        let tool = concat!("lexican ", env!("CARGO_PKG_VERSION"));
        format!(
            "{{\n  \"format\": \"lexican-check\",\n  \"version\": {VERSION},\n  \"tool\": \"{tool}\",\n  \"files\": ["
        )
    }

    fn file(&self, checked: &Checked) -> String {
        let findings = checked.findings.iter();
        let file = File {
            path: checked.source.name(),
            findings: findings.map(|finding| self::finding(checked.source, finding)).collect(),
        };
        format!("\n    {}", json_within(&file, 2))
    }

    fn between(&self) -> &'static str {
        ","
    }

    fn end(&self, run: &Run) -> String {
        let failures: Vec<String> = run.failures.iter().map(ToString::to_string).collect();
        let summary = Summary {
            files: run.files,
            counts: run.counts,
            hidden: run.hidden,
            fixed: run.fixed,
        };
        let (failures, summary) = (json_within(&failures, 1), json_within(&summary, 1));
        format!("\n  ],\n  \"failures\": {failures},\n  \"summary\": {summary}\n}}\n")
    }
}

fn finding<'a>(source: &'a Source, diagnostic: &'a Diagnostic) -> Finding<'a> {
    let related = diagnostic.related.iter().map(|related| Related {
        place: Place::of(source, related.span),
        label: &related.label,
    });
    Finding {
        code: diagnostic.code.as_str(),
        rule: rules::find(diagnostic.code.as_str()).map_or_else(String::new, rules::Rule::name),
        level: diagnostic.level.name(),
        message: &diagnostic.message,
        section: diagnostic.section.map(|header| source.slice(header)),
        place: (!diagnostic.about_file()).then(|| Place::of(source, diagnostic.span)),
        label: diagnostic.label.as_deref(),
        related: related.collect(),
        help: diagnostic.help.as_deref(),
        fixable: diagnostic.fix.is_some(),
    }
}
