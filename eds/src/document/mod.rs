//! A file as sections and entries, each with its place; written back as it was read.

mod duplicates;
mod edit;
mod keyword;
mod problem;
mod read;
mod section_name;
mod spelling;

pub use crate::source::Format;
pub(crate) use edit::ArrangedLine;
pub use edit::{Edit, EditError};
pub use keyword::Keyword;
pub use problem::Problem;
pub use section_name::{ModulePart, SectionName};

use crate::source::Source;
use crate::span::Span;

/// A file, read line by line.
///
/// Where a section or a keyword stands twice, both are here, the second also as a [problem](Problem::DuplicateSection).
/// **The first one counts**, for all later stages: so does `GetPrivateProfileString` of Windows, by which the tools of most
/// vendors read an EDS. (Python's `configparser`, and python-canopen with it, refuses such a file.)
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
    /// The text between the brackets, without the blanks around it.
    pub label: Span,
    /// In the order of the file, duplicates kept.
    pub entries: Vec<Entry>,
}

/// A keyword and its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// What the value is about.
    pub keyword: Keyword,
    /// The keyword as written.
    pub key: Span,
    /// The value as written, without the blanks around it; empty when there is none.
    ///
    /// CiA 306-1 has no comments behind a value: `rw # read/write` is the whole value.
    pub value: Span,
}

impl Document {
    /// Reads a file. What makes no sense becomes a [problem](Document::problems).
    #[must_use]
    pub fn read(source: Source) -> Self {
        let (sections, problems) = read::read(&source);
        Self {
            source,
            sections,
            problems,
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

    /// The section that `at` is in, its header included.
    #[must_use]
    pub fn section_around(&self, at: Span) -> Option<&Section> {
        let following = self
            .sections
            .partition_point(|section| section.header.start <= at.start);
        self.sections.get(following.checked_sub(1)?)
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

impl Section {
    /// The entry of `keyword`; the first, when there are more.
    #[must_use]
    pub fn entry(&self, keyword: Keyword) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.keyword == keyword)
    }
}
