//! A file as sections and entries, each with its place; written back as it was read.

mod keyword;
mod problem;
mod section_name;

pub use keyword::Keyword;
pub use problem::{Format, Problem};
pub use section_name::{ModulePart, SectionName};

use crate::ini;
use crate::source::Source;
use crate::span::Span;

/// A file, read line by line.
#[derive(Clone, Debug, Default)]
pub struct Document {
    source: Source,
    sections: Vec<Section>,
    problems: Vec<Problem>,
}

/// A section: its header and the entries up to the next header.
#[derive(Clone, Debug)]
pub struct Section {
    /// What it is about.
    pub name: SectionName,
    /// The header, from bracket to bracket.
    pub header: Span,
    /// The text between the brackets.
    pub label: Span,
    /// In the order of the file, duplicates kept.
    pub entries: Vec<Entry>,
}

/// A keyword and its value.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// What the value is about.
    pub keyword: Keyword,
    /// The keyword as written.
    pub key: Span,
    /// The value without the blanks around it; empty when there is none.
    pub value: Span,
}

impl Document {
    /// Reads a file. What makes no sense becomes a [problem](Document::problems).
    #[must_use]
    pub fn read(source: Source) -> Self {
        let sections = ini::read(&source)
            .into_iter()
            .map(|section| interpret(&source, section))
            .collect();
        Self {
            source,
            sections,
            problems: Vec::new(),
        }
    }

    /// The file's name, text and lines.
    #[must_use]
    pub const fn source(&self) -> &Source {
        &self.source
    }

    /// The sections in the order of the file, duplicates kept.
    #[must_use]
    pub fn sections(&self) -> &[Section] {
        &self.sections
    }

    /// What CiA 306-1 does not allow in lines and names, in the order of the file.
    #[must_use]
    pub fn problems(&self) -> &[Problem] {
        &self.problems
    }

    /// The text of `span`.
    #[must_use]
    pub fn text(&self, span: Span) -> &str {
        self.source.slice(span)
    }

    /// The bytes of the file; those that it was read from, when nothing was edited.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        self.source.to_bytes()
    }
}

fn interpret(source: &Source, section: ini::IniSection) -> Section {
    Section {
        name: SectionName::parse(source.slice(section.label)),
        header: section.header,
        label: section.label,
        entries: section
            .pairs
            .into_iter()
            .map(|(key, value)| Entry {
                keyword: Keyword::parse(source.slice(key)),
                key,
                value,
            })
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sections_and_entries_come_in_the_order_of_the_file() {
        let text = "[1018sub1]\r\nParameterName=Vendor-ID \r\nDataType=0x0007\r\n";
        let document = Document::read(Source::decode("x.eds", text.into()));
        let [section] = document.sections() else {
            panic!("one section")
        };
        assert_eq!(section.name, SectionName::Sub(0x1018, 1));
        let entries: Vec<_> = section
            .entries
            .iter()
            .map(|e| (e.keyword, document.text(e.value)))
            .collect();
        assert_eq!(
            entries,
            [(Keyword::ParameterName, "Vendor-ID"), (Keyword::DataType, "0x0007")]
        );
        let place = document.source().line_column(section.entries[1].value);
        assert_eq!((place.line, place.column), (3, 10));
        assert_eq!(document.to_bytes(), text.as_bytes());
    }
}
