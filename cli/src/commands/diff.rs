//! `lexican diff`: what differs between two devices, as a master sees it.

use std::{fmt::Write as _, path::PathBuf};

use anstyle::{AnsiColor, Style};
use clap::{Args, ValueEnum};
use lexican_eds::{
    Reading,
    diff::{self, Difference, Effect},
    document::Problem,
    render::printable,
    source::Source,
    span::Span,
};
use serde::Serialize;

use crate::{Verdict, failure::Failure, input::Input, output::Stdout};

/// Compare two EDS or DCF files: what changes for a master, breaking changes first
///
/// Compares the devices, not the texts: how the files are written makes no difference. Ends with 0 when the devices are the
/// same, with 1 when they differ, with 2 when a file cannot be read.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Diff {
    /// The EDS or DCF file of the device as it was, or `-` for standard input
    old: PathBuf,

    /// The EDS or DCF file of the device as it is, or `-` for standard input
    new: PathBuf,

    /// How to print the differences
    #[arg(long, value_enum, default_value_t)]
    format: Format,

    /// Look at differences of this effect and graver ones alone
    #[arg(long, value_enum, value_name = "EFFECT", default_value_t)]
    min_effect: MinEffect,
}

const EXAMPLES: &str = "\
Examples:
  lexican diff pump-1.0.eds pump-1.1.eds
  lexican diff --min-effect breaking pump-1.0.eds pump-1.1.eds
  git show HEAD:pump.eds | lexican diff - pump.eds";

#[derive(Clone, Copy, Default, ValueEnum)]
enum Format {
    /// For people: a difference a line
    #[default]
    Text,
    /// For programs, as docs/json.md of the repository describes it
    Json,
}

#[derive(Clone, Copy, Default, ValueEnum)]
enum MinEffect {
    /// What a master could do is no longer possible, or comes out otherwise
    Breaking,
    /// Something more is possible
    Addition,
    /// Names and descriptions
    #[default]
    Cosmetic,
}

impl Diff {
    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        if self.old == self.new {
            let path = self.old.display();
            return Err(Failure::new(format!("{path} is the same as itself; name two files")));
        }
        let (old, new) = (read(&Input::new(&self.old))?, read(&Input::new(&self.new))?);
        let mut found = diff::compare(&old.dictionary, &new.dictionary);
        found.retain(|difference| difference.effect <= self.min_effect.effect());
        let report = Report {
            old: old.document.source(),
            new: new.document.source(),
            found: &found,
        };
        match self.format {
            Format::Text => Stdout::styled().print(&report.text())?,
            Format::Json => Stdout::plain().print(&report.json())?,
        }
        Ok(if found.is_empty() {
            Verdict::Clean
        } else {
            Verdict::Findings
        })
    }
}

impl MinEffect {
    const fn effect(self) -> Effect {
        match self {
            Self::Breaking => Effect::Breaking,
            Self::Addition => Effect::Addition,
            Self::Cosmetic => Effect::Cosmetic,
        }
    }
}

/// A file that describes something: anything else would differ in everything.
fn read(input: &Input) -> Result<Reading, Failure> {
    let name = input.name();
    let reading = lexican_eds::read(name.clone(), input.read()?);
    let is_foreign = matches!(reading.document.problems(), [Problem::NotCanopen { .. }, ..]);
    if is_foreign || reading.dictionary.objects.is_empty() {
        return Err(Failure::new(format!(
            "{name} describes no object; `lexican check {name}` says what it is, `lexican validate` holds a dump against a file"
        )));
    }
    Ok(reading)
}

/// What there is to say.
struct Report<'a> {
    old: &'a Source,
    new: &'a Source,
    found: &'a [Difference],
}

impl Report<'_> {
    /// A line for each difference, and a summary.
    fn text(&self) -> String {
        let mut text = String::new();
        for difference in self.found {
            let (style, effect) = (style(difference.effect), difference.effect.name());
            let fact = printable(&difference.to_string());
            let _ = writeln!(text, "{style}{effect}{style:#}: {fact}{}", self.lines(difference));
        }
        let _ = writeln!(text, "{}", printable(&self.summary()));
        text
    }

    /// ` (line 12, now 14)`
    fn lines(&self, difference: &Difference) -> String {
        let line = |source: &Source, place: Option<Span>| place.map(|place| source.line_column(place).line);
        match (line(self.old, difference.old), line(self.new, difference.new)) {
            (Some(old), Some(new)) => format!(" (line {old}, now {new})"),
            (Some(old), None) => format!(" (was line {old})"),
            (None, Some(new)) => format!(" (line {new})"),
            (None, None) => String::new(),
        }
    }

    /// `pump-1.eds → pump-2.eds: 1 breaking, 2 additions`
    fn summary(&self) -> String {
        let counts = [
            (Effect::Breaking, "breaking", "breaking"),
            (Effect::Addition, "addition", "additions"),
            (Effect::Cosmetic, "cosmetic", "cosmetic"),
        ];
        let counts = counts
            .into_iter()
            .filter_map(|(effect, one, many)| match self.count(effect) {
                0 => None,
                1 => Some(format!("1 {one}")),
                number => Some(format!("{number} {many}")),
            });
        let counts: Vec<String> = counts.collect();
        let counts = if counts.is_empty() {
            "no difference".to_owned()
        } else {
            counts.join(", ")
        };
        format!("{} → {}: {counts}", self.old.name(), self.new.name())
    }

    fn count(&self, effect: Effect) -> usize {
        self.found
            .iter()
            .filter(|difference| difference.effect == effect)
            .count()
    }

    fn json(&self) -> String {
        let place = |source: &Source, place: Option<Span>| {
            place.map(|place| {
                let start = source.line_column(place);
                Place {
                    line: start.line,
                    column: start.column,
                }
            })
        };
        let differences = self.found.iter().map(|difference| Json {
            effect: difference.effect.name(),
            subject: &difference.subject,
            name: &difference.name,
            fact: difference.fact,
            before: difference.before.as_deref(),
            after: difference.after.as_deref(),
            message: difference.to_string(),
            old: place(self.old, difference.old),
            new: place(self.new, difference.new),
        });
        let root = Root {
            format: "lexican-diff",
            version: VERSION,
            tool: concat!("lexican ", env!("CARGO_PKG_VERSION")),
            old: self.old.name(),
            new: self.new.name(),
            differences: differences.collect(),
            summary: Summary {
                breaking: self.count(Effect::Breaking),
                addition: self.count(Effect::Addition),
                cosmetic: self.count(Effect::Cosmetic),
            },
        };
        // Only maps whose keys are no strings cannot be written, and there is none.
        serde_json::to_string_pretty(&root).unwrap_or_default() + "\n"
    }
}

fn style(effect: Effect) -> Style {
    match effect {
        Effect::Breaking => AnsiColor::BrightRed.on_default().bold(),
        Effect::Addition => AnsiColor::BrightGreen.on_default().bold(),
        Effect::Cosmetic => Style::new().bold(),
    }
}

/// Counts what would break a reader; docs/json.md promises the form.
const VERSION: u32 = 1;

#[derive(Serialize)]
struct Root<'a> {
    format: &'static str,
    version: u32,
    tool: &'static str,
    old: &'a str,
    new: &'a str,
    differences: Vec<Json<'a>>,
    summary: Summary,
}

#[derive(Serialize)]
struct Json<'a> {
    effect: &'static str,
    subject: &'a str,
    name: &'a str,
    fact: Option<&'static str>,
    before: Option<&'a str>,
    after: Option<&'a str>,
    message: String,
    old: Option<Place>,
    new: Option<Place>,
}

#[derive(Serialize)]
struct Place {
    line: u32,
    column: u32,
}

#[derive(Serialize)]
struct Summary {
    breaking: usize,
    addition: usize,
    cosmetic: usize,
}
