//! The lines of the file that a diagnostic is about, with their numbers, carets and labels.

use std::ops::Range;

use super::{
    cells::{Excerpt, excerpt, printable},
    palette::Palette,
};
use crate::{
    diagnostic::{Diagnostic, Level},
    source::Source,
    span::Span,
};

pub(super) struct Snippet<'a> {
    level: Level,
    /// By line.
    marks: Vec<Mark<'a>>,
}

/// As many related places are shown; a finding can have hundreds, and says then how many in its message.
const MOST_RELATED: usize = 3;

/// A place in the file that is underlined.
struct Mark<'a> {
    /// Counted from 1.
    number: u32,
    line: &'a str,
    /// Bytes of the line.
    range: Range<usize>,
    kind: Kind,
    label: &'a str,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Primary,
    Related,
    /// Shown, not underlined.
    Section,
}

impl<'a> Snippet<'a> {
    /// The header of the section, the primary place and the first related ones, in the order of the file. Empty for a finding about the file as a whole.
    pub(super) fn new(source: &'a Source, diagnostic: &'a Diagnostic) -> Self {
        let label = diagnostic.label.as_deref().unwrap_or_default();
        let primary = (!diagnostic.about_file()).then(|| mark(source, diagnostic.span, Kind::Primary, label));
        let related = diagnostic.related.iter().take(MOST_RELATED);
        let related = related.map(|related| mark(source, related.span, Kind::Related, &related.label));
        let section = diagnostic.section.map(|header| mark(source, header, Kind::Section, ""));
        let mut marks: Vec<Mark> = primary.into_iter().chain(related).chain(section).collect();
        marks.sort_by_key(|mark| mark.number);
        Self {
            level: diagnostic.level,
            marks,
        }
    }

    /// Digits of the largest line number; what stands below the snippet is indented as far.
    pub(super) fn gutter_width(&self) -> usize {
        let last = self.marks.last().map_or(0, |mark| mark.number);
        last.checked_ilog10().map_or(0, |digits| digits as usize + 1)
    }

    /// The lines, between two empty ones. The text of each is at most about `columns` wide.
    pub(super) fn render(&self, palette: &Palette, columns: usize) -> String {
        if self.marks.is_empty() {
            return String::new();
        }
        let mut rows = self.bar(palette, "");
        let mut last: Option<(u32, String)> = None;
        for mark in &self.marks {
            let excerpt = excerpt(mark.line, mark.range.clone(), columns);
            let underline = self.underline(palette, mark, &excerpt);
            let shown = (mark.number, excerpt.text);
            if last.as_ref() != Some(&shown) {
                rows.push_str(&elision(palette, last.as_ref(), mark.number));
                rows.push_str(&self.line(palette, &shown));
            }
            rows.push_str(&underline);
            last = Some(shown);
        }
        rows.push_str(&self.bar(palette, ""));
        rows
    }

    fn line(&self, palette: &Palette, (number, text): &(u32, String)) -> String {
        let (width, gutter) = (self.gutter_width(), palette.gutter);
        format!("{gutter}{number:width$} |{gutter:#} {text}\n")
    }

    /// The signs under the marked columns and the words beside them; the spaces before stay without colour.
    fn underline(&self, palette: &Palette, mark: &Mark, excerpt: &Excerpt) -> String {
        let (sign, style) = match mark.kind {
            Kind::Primary => ("^", palette.level(self.level).1),
            Kind::Related => ("-", palette.gutter),
            Kind::Section => return String::new(),
        };
        let (indent, signs) = (excerpt.indent, sign.repeat(excerpt.width));
        let label = printable(mark.label);
        let space = if label.is_empty() { "" } else { " " };
        self.bar(palette, &format!("{:indent$}{style}{signs}{space}{label}{style:#}", ""))
    }

    /// A row without a line number.
    fn bar(&self, palette: &Palette, row: &str) -> String {
        let (width, gutter) = (self.gutter_width(), palette.gutter);
        let space = if row.is_empty() { "" } else { " " };
        format!("{:width$} {gutter}|{gutter:#}{space}{row}\n", "")
    }
}

fn mark<'a>(source: &'a Source, span: Span, kind: Kind, label: &'a str) -> Mark<'a> {
    let number = source.line_column(span).line;
    let line = source.line_span(number);
    let within = |offset: u32| offset.clamp(line.start, line.end).saturating_sub(line.start) as usize;
    Mark {
        number,
        line: source.slice(line),
        range: within(span.start)..within(span.end),
        kind,
        label,
    }
}

/// The row that says that lines were left out between the last shown and `number`.
fn elision(palette: &Palette, last: Option<&(u32, String)>, number: u32) -> String {
    let gutter = palette.gutter;
    match last {
        Some((shown, _)) if number > shown + 1 => format!("{gutter}...{gutter:#}\n"),
        _ => String::new(),
    }
}
