//! SARIF 2.1.0, for code scanning services.
//!
//! The types in [`log`] are the part of the standard that we write. Results come first, the rules behind them: only the
//! end of the run knows which of them found something.

mod fingerprint;
mod fix;
mod location;
mod log;
mod rule;

use lexican_eds::diagnostic::{Diagnostic, Level};

use self::{
    fingerprint::Fingerprints,
    log::{Driver, Invocation, Message, Notification, RelatedLocation, SarifResult, Tool},
};
use super::{Checked, Form, Run, json_within};

const SCHEMA: &str = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

pub(super) struct Sarif;

impl Form for Sarif {
    fn begin(&self) -> String {
        format!(
            "{{\n  \"$schema\": \"{SCHEMA}\",\n  \"version\": \"2.1.0\",\n  \"runs\": [\n    {{\n      \
             \"columnKind\": \"unicodeCodePoints\",\n      \"results\": ["
        )
    }

    fn file(&self, checked: &Checked) -> String {
        let mut fingerprints = Fingerprints::new(checked.source);
        let results = checked.findings.iter().map(|finding| {
            let result = result(checked, finding, fingerprints.of(finding));
            format!("\n        {}", json_within(&result, 4))
        });
        results.collect::<Vec<_>>().join(",")
    }

    fn between(&self) -> &'static str {
        ","
    }

    fn end(&self, run: &Run) -> String {
        let tool = Tool {
            driver: Driver {
                name: "lexican",
                semantic_version: env!("CARGO_PKG_VERSION"),
                information_uri: env!("CARGO_PKG_REPOSITORY"),
                rules: run.codes.iter().filter_map(|code| rule::described(*code)).collect(),
            },
        };
        let failures = run.failures.iter().map(|failure| Notification {
            level: "error",
            message: Message::literal(&failure.to_string()),
        });
        let invocation = Invocation {
            execution_successful: run.failures.is_empty(),
            tool_execution_notifications: failures.collect(),
        };
        let (tool, invocations) = (json_within(&tool, 3), json_within(&[invocation], 3));
        format!("\n      ],\n      \"tool\": {tool},\n      \"invocations\": {invocations}\n    }}\n  ]\n}}\n")
    }
}

fn result<'a>(checked: &'a Checked, finding: &'a Diagnostic, fingerprint: String) -> SarifResult<'a> {
    let source = checked.source;
    let section = finding.section.map(|header| source.slice(header));
    let related = finding.related.iter().map(|related| RelatedLocation {
        location: location::of(source, Some(related.span), None),
        message: Message::literal(&related.label),
    });
    let fixes = finding
        .fix
        .iter()
        .filter_map(|cure| fix::of(checked.document, finding, cure));
    let place = (!finding.about_file()).then_some(finding.span);
    SarifResult {
        rule_id: finding.code.as_str(),
        level: level(finding.level),
        message: Message::literal(&sentence(finding)),
        locations: [location::of(source, place, section)],
        related_locations: related.collect(),
        fixes: fixes.collect(),
        partial_fingerprints: fingerprint.into(),
    }
}

/// The fact and the cure: a service shows nothing else beside the line.
fn sentence(finding: &Diagnostic) -> String {
    match &finding.help {
        Some(help) => format!("{}; {help}", finding.message),
        None => finding.message.clone(),
    }
}

const fn level(level: Level) -> &'static str {
    match level {
        Level::Deny => "error",
        Level::Warn => "warning",
        Level::Note => "note",
        Level::Allow => "none",
    }
}
