//! Lines to sections, and what is wrong with them.

use super::duplicates;
use super::{Entry, Format, Keyword, Problem, Section, SectionName};
use crate::ini::{self, Header, Line};
use crate::source::{LineEnd, Source};
use crate::span::Span;

/// The longest line that CiA 306-1 allows, in characters.
const LONGEST_LINE: usize = 255;

/// Sections and problems of a file, both in its order.
pub(super) fn read(source: &Source) -> (Vec<Section>, Vec<Problem>) {
    let foreign = |what, at| (Vec::new(), vec![Problem::NotCanopen { what, at }]);
    if let Some(what) = source.foreign_format() {
        return foreign(what, first_text(source));
    }
    let mut reader = Reader::new(source);
    ini::read(source).for_each(|line| reader.line(line));
    if let Some((what, at)) = reader.foreign_format() {
        return foreign(what, at);
    }
    reader.finish()
}

struct Reader<'a> {
    source: &'a Source,
    sections: Vec<Section>,
    problems: Vec<Problem>,
}

impl<'a> Reader<'a> {
    fn new(source: &'a Source) -> Self {
        Self {
            source,
            sections: Vec::new(),
            problems: Vec::new(),
        }
    }

    fn line(&mut self, line: Line) {
        match line {
            Line::Header { line, pairs } => self.header(line, pairs),
            Line::Pair { key, value } => self.pair(key, value),
            Line::MissingKey(at) => self.problems.push(Problem::MissingKeyword { at }),
            Line::HashComment(at) => self.problems.push(Problem::HashComment { at }),
            Line::Junk(at) => self.problems.push(Problem::JunkLine { at }),
        }
    }

    fn header(&mut self, line: Span, pairs: usize) {
        let Header {
            brackets: header,
            label,
            rest,
            closed,
        } = Header::of(self.source.slice(line), line.start);
        let text = self.source.slice(label);
        let name = SectionName::parse(text);
        let padded = closed && label.len() + 2 < header.len();
        let found = [
            (!closed).then_some(Problem::MalformedHeader { at: line }),
            (!self.in_column_1(line)).then_some(Problem::IndentedHeader { at: header }),
            (!rest.is_empty()).then_some(Problem::TextAfterHeader { at: rest }),
            (name == SectionName::Unknown).then_some(Problem::UnknownSection { at: label }),
            (name != SectionName::Unknown && (padded || !name.is_spelled(text)))
                .then_some(Problem::BadSectionName { at: label }),
        ];
        self.problems.extend(found.into_iter().flatten());
        self.sections.push(Section {
            name,
            header,
            label,
            entries: Vec::with_capacity(pairs),
        });
    }

    fn in_column_1(&self, line: Span) -> bool {
        let before = self.source.text().as_bytes().get(..line.start as usize);
        before.is_some_and(|before| matches!(before.last(), None | Some(b'\n' | b'\r')))
    }

    fn pair(&mut self, key: Span, value: Span) {
        let Some(section) = self.sections.last_mut() else {
            self.problems.push(Problem::KeywordOutsideSection { at: key });
            return;
        };
        let keyword = Keyword::parse(self.source.slice(key));
        section.entries.push(Entry { keyword, key, value });
        if keyword == Keyword::Unknown && section.name != SectionName::Unknown {
            self.problems.push(Problem::UnknownKeyword { at: key });
        }
        let at = Span::new(key.start, value.end);
        if at.len() > LONGEST_LINE {
            self.overlong(at);
        }
    }

    fn overlong(&mut self, at: Span) {
        let characters = self.source.slice(at).chars().count();
        if characters > LONGEST_LINE {
            let characters = u32::try_from(characters).unwrap_or(u32::MAX);
            self.problems.push(Problem::OverlongLine { at, characters });
        }
    }

    /// What a file is whose sections are not those of an EDS.
    fn foreign_format(&self) -> Option<(Format, Span)> {
        let Some(first) = self.sections.first() else {
            return Some((Format::Text, first_text(self.source)));
        };
        if self.sections.iter().any(|section| section.name != SectionName::Unknown) {
            return None;
        }
        let odva = self.sections.iter().find(|section| {
            let label = self.source.slice(section.label);
            label.eq_ignore_ascii_case("File") || label.eq_ignore_ascii_case("Device")
        });
        Some(odva.map_or((Format::Ini, first.header), |section| (Format::Odva, section.header)))
    }

    fn finish(mut self) -> (Vec<Section>, Vec<Problem>) {
        self.problems.extend(duplicates::find(self.source, &self.sections));
        self.problems.extend(beyond_ascii(self.source));
        self.problems.extend(mixed_line_ends(self.source));
        self.problems.sort_by_key(|problem| problem.span().start);
        if self.source.byte_order_mark() {
            let at = self.source.line_span(1);
            self.problems.insert(0, Problem::ByteOrderMark { at });
        }
        (self.sections, self.problems)
    }
}

/// Characters that an EDS shall not have: one problem a line and kind.
fn beyond_ascii(source: &Source) -> impl Iterator<Item = Problem> {
    let is_plain = |byte: u8| matches!(byte, b' '..=b'~' | b'\t' | b'\n' | b'\r');
    // All bytes of a chunk, without a way out in between: that is fast.
    let plain = |chunk: &[u8]| chunk.iter().fold(true, |all, byte| all & is_plain(*byte));
    let all_plain = source.text().as_bytes().chunks(256).all(plain);
    let lines = if all_plain { 0 } else { source.line_count() };
    (1..=lines).flat_map(|number| {
        let line = source.line_span(number);
        let characters = source.slice(line).char_indices();
        let place = move |at, character: char| {
            let start = line.start as usize + at;
            Span::of(start..start + character.len_utf8())
        };
        let not_ascii = characters.clone().find(|(_, character)| !character.is_ascii());
        let control = characters
            .clone()
            .find(|(_, character)| character.is_ascii_control() && *character != '\t');
        let encoding = source.encoding(number);
        [
            not_ascii.map(|(at, character)| Problem::NotAscii {
                at: place(at, character),
                encoding,
            }),
            control.map(|(at, character)| Problem::ControlCharacter {
                at: place(at, character),
                character,
            }),
        ]
        .into_iter()
        .flatten()
    })
}

/// The first line that ends otherwise than the first line.
fn mixed_line_ends(source: &Source) -> Option<Problem> {
    let end = |line: Span| LineEnd::of(source.slice(line));
    let first = source.lines().next().map(end)?;
    let mut lines = (1..).zip(source.lines().map(end));
    let (number, _) = lines.find(|(_, end)| *end != first && *end != LineEnd::None)?;
    let at = source.line_span(number);
    Some(Problem::MixedLineEnds { at })
}

/// The first line that is not blank.
fn first_text(source: &Source) -> Span {
    let mut lines = (1..=source.line_count()).map(|number| source.line_span(number));
    lines
        .find(|line| !source.slice(*line).trim().is_empty())
        .unwrap_or_default()
}
