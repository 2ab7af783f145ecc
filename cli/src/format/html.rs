//! One page for a browser, with everything in it: it can be mailed, archived, and opened without a network.

use lexican_eds::{
    diagnostic::{Diagnostic, Level},
    render::{Renderer, printable},
    rules::{self, Rule},
    source::Source,
};
use lexican_templates::{Template, Value, context, report};

use super::{Checked, Form, Run};

pub(super) struct Html;

impl Form for Html {
    fn begin(&self) -> String {
        render(report::BEGIN, context! {})
    }

    fn file(&self, checked: &Checked) -> String {
        let findings = checked.findings.iter();
        let findings: Vec<Value> = findings.map(|finding| self::finding(checked.source, finding)).collect();
        render(
            report::FILE,
            context! { name => printable(checked.source.name()), findings => findings },
        )
    }

    fn end(&self, run: &Run) -> String {
        let failures: Vec<String> = run.failures.iter().map(ToString::to_string).collect();
        let tool = concat!("lexican ", env!("CARGO_PKG_VERSION"));
        render(
            report::END,
            context! {
                summary => run.to_string(),
                failures => failures,
                deny => run.counts.deny,
                warn => run.counts.warn,
                note => run.counts.note,
                tool => tool,
            },
        )
    }
}

/// The templates are ours, and a test renders each: that one fails is seen on the page.
fn render(template: Template<'_>, context: Value) -> String {
    template.render(context).unwrap_or_else(|error| error.to_string())
}

fn finding(source: &Source, finding: &Diagnostic) -> Value {
    let code = finding.code.as_str();
    let line = source.line_column(finding.span).line;
    context! {
        level => finding.level.name(),
        word => word(finding.level),
        code => code,
        rule => rules::find(code).map_or_else(String::new, Rule::name),
        section => finding.section.map(|header| printable(source.slice(header))),
        message => printable(&finding.message),
        line => (!finding.about_file()).then_some(line),
        help => finding.help.as_deref().map(printable),
        page => Renderer::plain().render(source, finding),
    }
}

const fn word(level: Level) -> &'static str {
    match level {
        Level::Deny => "error",
        Level::Warn => "warning",
        Level::Note | Level::Allow => "note",
    }
}
