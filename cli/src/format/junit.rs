//! JUnit XML: a suite a file, a test case a finding.
//!
//! What is denied has failed, so that failures and exit code agree; a warning and a note are test cases that passed and
//! have something to say. A file without a finding is one test case that passed.

use std::io;

use lexican_eds::{
    diagnostic::{Diagnostic, Level},
    render::{Renderer, printable},
    rules::{self, Rule},
};
use quick_xml::{Writer, events::BytesText};

use super::{Checked, Counts, Form, Run};

type Xml = Writer<Vec<u8>>;

pub(super) struct Junit;

impl Form for Junit {
    fn begin(&self) -> String {
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"lexican\">\n".into()
    }

    fn file(&self, checked: &Checked) -> String {
        let name = legal(&printable(checked.source.name()));
        let counts: Counts = checked.findings.iter().collect();
        let tests = checked.findings.len().max(1);
        element(|xml| suite(xml, &name, [tests, counts.deny, 0], |xml| cases(xml, &name, checked)))
    }

    /// What could not be read is a suite of its own.
    fn end(&self, run: &Run) -> String {
        let failed = run.failures.len();
        let failures = |xml: &mut Xml| {
            for failure in &run.failures {
                case(xml, "files", "readable", |xml| {
                    problem(xml, "error", "unreadable", &failure.to_string(), "")
                })?;
            }
            Ok(())
        };
        let suite = match failed {
            0 => String::new(),
            _ => element(|xml| suite(xml, "lexican", [failed, 0, failed], failures)),
        };
        suite + "</testsuites>\n"
    }
}

/// A child of the root, as text.
fn element(write: impl FnOnce(&mut Xml) -> io::Result<()>) -> String {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    // Writing to memory does not fail.
    let _ = write(&mut xml);
    let text = String::from_utf8(xml.into_inner()).unwrap_or_default();
    text.trim_start_matches('\n').to_owned() + "\n"
}

fn suite(
    xml: &mut Xml,
    name: &str,
    [tests, failures, errors]: [usize; 3],
    content: impl FnOnce(&mut Xml) -> io::Result<()>,
) -> io::Result<()> {
    let numbers = [tests, failures, errors].map(|number| number.to_string());
    let [tests, failures, errors] = &numbers;
    let suite = xml.create_element("testsuite").with_attributes([
        ("name", name),
        ("tests", tests),
        ("failures", failures),
        ("errors", errors),
    ]);
    suite.write_inner_content(content).map(drop)
}

fn cases(xml: &mut Xml, file: &str, checked: &Checked) -> io::Result<()> {
    if checked.findings.is_empty() {
        return case(xml, file, "no findings", |_| Ok(()));
    }
    for finding in checked.findings {
        let page = Renderer::plain().render(checked.source, finding);
        let line = checked.source.line_column(finding.span).line;
        let name = if finding.about_file() {
            title(finding)
        } else {
            format!("{} at line {line}", title(finding))
        };
        case(xml, file, &name, |xml| outcome(xml, finding, &page))?;
    }
    Ok(())
}

/// `OBJ002 inverted limits`
fn title(finding: &Diagnostic) -> String {
    let code = finding.code.as_str();
    let name = rules::find(code).map_or_else(String::new, Rule::name);
    format!("{code} {name}")
}

fn outcome(xml: &mut Xml, finding: &Diagnostic, page: &str) -> io::Result<()> {
    if finding.level == Level::Deny {
        return problem(
            xml,
            "failure",
            finding.code.as_str(),
            &printable(&finding.message),
            page,
        );
    }
    let page = legal(page);
    let element = xml.create_element("system-out");
    element.write_text_content(BytesText::new(&page)).map(drop)
}

fn problem(xml: &mut Xml, element: &str, kind: &str, message: &str, page: &str) -> io::Result<()> {
    let (message, page) = (legal(message), legal(page));
    let element = xml.create_element(element);
    let element = element.with_attributes([("type", kind), ("message", &message)]);
    element.write_text_content(BytesText::new(&page)).map(drop)
}

fn case(xml: &mut Xml, class: &str, name: &str, content: impl FnOnce(&mut Xml) -> io::Result<()>) -> io::Result<()> {
    let case = xml.create_element("testcase");
    let case = case.with_attributes([("classname", class), ("name", name)]);
    case.write_inner_content(content).map(drop)
}

/// Printable text without the two characters that XML does not know.
fn legal(text: &str) -> String {
    text.replace(['\u{FFFE}', '\u{FFFF}'], "\u{FFFD}")
}
