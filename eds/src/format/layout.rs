//! The lines of a file in canonical order.

use std::collections::BTreeMap;

use super::value;
use crate::{
    Reading,
    document::{ArrangedLine, Document, Entry, Keyword, Problem, Section, SectionName},
    ini,
    ir::ObjectList,
    span::Span,
};

/// What a line is.
#[derive(Clone, Copy)]
enum Kind<'d> {
    Blank,
    /// A comment.
    Comment,
    /// What a reader passes over, without being told to.
    Junk,
    Header(&'d Section),
    Entry(&'d Section, &'d Entry),
}

/// A line with what belongs to it.
struct Block {
    /// Comments above it; 0 stands for a blank line between them.
    above: Vec<u32>,
    line: ArrangedLine,
    /// Junk below it, which may be the rest of it.
    below: Vec<u32>,
}

/// A section with all that belongs to it.
struct Part<'d> {
    section: &'d Section,
    header: Block,
    entries: Vec<(Keyword, Block)>,
    /// Comments behind the last entry.
    end: Vec<u32>,
}

/// The lines of the file in canonical order.
pub(super) fn lines(reading: &Reading) -> Vec<ArrangedLine> {
    let document = &reading.document;
    let mut layout = Layout::default();
    for (number, kind) in kinds(document) {
        layout.line(document, number, kind);
    }
    let Layout {
        top,
        mut parts,
        pending,
    } = layout;
    if let Some(last) = parts.last_mut() {
        last.end.extend(pending);
    }
    let list_of = |index| {
        let object = reading.dictionary.object(index);
        object.and_then(|object| object.list).unwrap_or(ObjectList::of(index))
    };
    // Of sections and keywords that stand twice the first one counts, so that they keep their order.
    parts.sort_by_key(|part| part.section.name.order(list_of));
    let mut written = Written {
        document,
        lines: Vec::new(),
    };
    written.comments(&top);
    for part in &mut parts {
        part.entries.sort_by_key(|(keyword, _)| keyword.order());
        written.part(part);
    }
    written.lines
}

/// Each line with its number.
fn kinds(document: &Document) -> impl Iterator<Item = (u32, Kind<'_>)> {
    let source = document.source();
    let line = |at: Span| source.line_column(at).line;
    let mut known = BTreeMap::new();
    for section in document.sections() {
        known.insert(line(section.header), Kind::Header(section));
        for entry in &section.entries {
            known.insert(line(entry.key), Kind::Entry(section, entry));
        }
    }
    for problem in document.problems() {
        if let Problem::JunkLine { at } | Problem::MissingKeyword { at } | Problem::KeywordOutsideSection { at } =
            *problem
        {
            known.insert(line(at), Kind::Junk);
        }
    }
    (1..=source.line_count()).map(move |number| {
        let is_blank = ini::trim(source.line_text(number)).is_empty();
        let other = if is_blank { Kind::Blank } else { Kind::Comment };
        (number, known.get(&number).copied().unwrap_or(other))
    })
}

/// A file, read line by line.
#[derive(Default)]
struct Layout<'d> {
    /// Comments before the first section.
    top: Vec<u32>,
    parts: Vec<Part<'d>>,
    /// Comments whose line is to come.
    pending: Vec<u32>,
}

impl<'d> Layout<'d> {
    fn line(&mut self, document: &'d Document, number: u32, kind: Kind<'d>) {
        match kind {
            Kind::Blank if self.pending.is_empty() => {}
            Kind::Blank => self.pending.push(0),
            Kind::Comment => self.pending.push(number),
            Kind::Junk => self.junk(number),
            Kind::Header(section) => self.header(document, number, section),
            Kind::Entry(section, entry) => {
                let text = entry_line(document, section, entry);
                let block = self.block(ArrangedLine { was: number, text });
                if let Some(part) = self.parts.last_mut() {
                    part.entries.push((entry.keyword, block));
                }
            }
        }
    }

    /// Junk right below a line stays there.
    fn junk(&mut self, number: u32) {
        let last = self.parts.last_mut().filter(|_| self.pending.is_empty());
        match last {
            Some(part) => {
                let block = part.entries.last_mut().map_or(&mut part.header, |(_, block)| block);
                block.below.push(number);
            }
            None => self.pending.push(number),
        }
    }

    /// Comments that a blank line parts from the header belong to what was before.
    fn header(&mut self, document: &'d Document, number: u32, section: &'d Section) {
        let parted = match self.parts.last() {
            None => self.pending.len(),
            Some(_) => self
                .pending
                .iter()
                .rposition(|line| *line == 0)
                .map_or(0, |blank| blank + 1),
        };
        let own = self.pending.split_off(parted);
        let before = std::mem::replace(&mut self.pending, own);
        match self.parts.last_mut() {
            Some(part) => part.end.extend(before),
            None => self.top = before,
        }
        let text = header_line(document, number, section);
        let header = self.block(ArrangedLine { was: number, text });
        self.parts.push(Part {
            section,
            header,
            entries: Vec::with_capacity(section.entries.len()),
            end: Vec::new(),
        });
    }

    fn block(&mut self, line: ArrangedLine) -> Block {
        Block {
            above: std::mem::take(&mut self.pending),
            line,
            below: Vec::new(),
        }
    }
}

/// The header, unless it is more than a header, or less.
fn header_line(document: &Document, number: u32, section: &Section) -> String {
    let line = ini::trim(document.source().line_text(number));
    let header = document.text(section.header);
    if header == line && header.starts_with('[') && header.ends_with(']') {
        let label = document.text(section.label);
        return format!("[{}]", section.name.spelling().unwrap_or_else(|| label.to_owned()));
    }
    line.to_owned()
}

fn entry_line(document: &Document, section: &Section, entry: &Entry) -> String {
    let key = document.text(entry.key);
    let known = (section.name != SectionName::Unknown)
        .then(|| entry.keyword.spelling())
        .flatten();
    let key = known.unwrap_or_else(|| key.to_owned());
    format!("{key}={}", value::canonical(document, section, entry))
}

/// The lines as they come to stand.
struct Written<'d> {
    document: &'d Document,
    lines: Vec<ArrangedLine>,
}

impl Written<'_> {
    fn part(&mut self, part: &Part<'_>) {
        if !self.lines.is_empty() {
            self.blank();
        }
        self.block(&part.header);
        for (_, block) in &part.entries {
            self.block(block);
        }
        self.comments(&part.end);
    }

    fn block(&mut self, block: &Block) {
        self.comments(&block.above);
        self.lines.push(block.line.clone());
        self.comments(&block.below);
    }

    /// As they are, with no more than one blank line between two of them.
    fn comments(&mut self, numbers: &[u32]) {
        let mut parted = false;
        let mut first = true;
        for number in numbers {
            if *number == 0 {
                parted = !first;
                continue;
            }
            if std::mem::take(&mut parted) {
                self.blank();
            }
            first = false;
            let text = self.document.source().line_text(*number).trim_end().to_owned();
            self.lines.push(ArrangedLine { was: *number, text });
        }
    }

    fn blank(&mut self) {
        self.lines.push(ArrangedLine {
            was: 0,
            text: String::new(),
        });
    }
}
