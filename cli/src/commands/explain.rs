//! `lexican explain`: the rules' documentation.

use std::fmt::Write as _;

use anstyle::Style;
use clap::Args;
use lexican_eds::rules::{self, Family, Rule, UnknownRule};

use crate::{Verdict, failure::Failure, output::Stdout};

/// Explain a rule: what it finds, why that matters, and the cure
///
/// Without a code it lists all rules.
#[derive(Args)]
pub(crate) struct Explain {
    /// A rule's code, such as EDS004, or the letters of a family, such as INI
    code: Option<String>,

    /// Print the pages of all rules as one Markdown document
    #[arg(long, conflicts_with = "code")]
    all: bool,
}

impl Explain {
    /// The page of one rule or the list of one family.
    pub(super) fn of(code: String) -> Self {
        Self {
            code: Some(code),
            all: false,
        }
    }

    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        let text = match self.code {
            _ if self.all => rules::manual(),
            Some(code) => explain(&code)?,
            None => rules::families().iter().map(list).collect::<Vec<_>>().join("\n"),
        };
        Stdout::styled().print(&text)?;
        Ok(Verdict::Clean)
    }
}

fn explain(code: &str) -> Result<String, Failure> {
    if let Some(rule) = rules::find(code) {
        return Ok(highlight(&rules::page(rule)));
    }
    let mut families = rules::families().iter();
    let family = families.find(|family| family.letters.eq_ignore_ascii_case(code));
    let unknown = || Failure::new(UnknownRule(code.to_owned()).to_string());
    family.map(list).ok_or_else(unknown)
}

/// The rules of a family, one a line.
fn list(family: &Family) -> String {
    let (letters, title) = (family.letters, family.title);
    let mut text = highlight(&format!("# {letters}: {title}\n"));
    for rule in rules::all().iter().filter(|rule| rule.code().family() == letters) {
        text.push_str(&row(rule));
    }
    text
}

fn row(rule: &Rule) -> String {
    format!("{}  {:<4}  {}\n", rule.code(), rule.level(), rule.name())
}

/// The same text with its headings in bold; a `#` in an example is none.
fn highlight(page: &str) -> String {
    let bold = Style::new().bold();
    let mut in_example = false;
    let mut text = String::new();
    for line in page.lines() {
        in_example ^= line.starts_with("```");
        let heading = !in_example && line.starts_with('#');
        let style = if heading { bold } else { Style::new() };
        let _ = writeln!(text, "{style}{line}{style:#}");
    }
    text
}
