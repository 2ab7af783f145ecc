//! Lists of objects, numbered and counted anew.

use crate::{
    document::{Document, Edit, EditError, Entry, Keyword, Section, SectionName},
    ir::ObjectList,
    literal,
    span::Span,
};

/// What becomes of one list.
#[derive(Debug, Default)]
pub(super) struct ListChange {
    /// The values of the lines that go.
    pub(super) struck: Vec<Span>,
    /// The objects that come.
    pub(super) enlisted: Vec<u16>,
}

/// A list as it will be: its lines in the order of their numbers, each with the number that it gets.
struct Numbered<'d> {
    kept: Vec<(&'d Entry, u32)>,
    struck: Vec<&'d Entry>,
    /// How many objects are listed, not counting those that come.
    listed: u32,
}

impl ListChange {
    /// Puts the changes into `edit` and tells what text of the document they replace.
    pub(super) fn make(
        &mut self,
        list: ObjectList,
        edit: &mut Edit<'_>,
        document: &Document,
    ) -> Result<Vec<Span>, EditError> {
        self.struck.sort_unstable();
        self.enlisted.sort_unstable();
        self.enlisted.dedup();
        let mut sections = document.sections().iter();
        match sections.find(|section| section.name == list.section_name()) {
            Some(section) => self.change(section, edit, document),
            None => self.write(list, edit, document).map(|()| Vec::new()),
        }
    }

    fn change(&self, section: &Section, edit: &mut Edit<'_>, document: &Document) -> Result<Vec<Span>, EditError> {
        let numbered = self.number(section, document);
        let mut replaced = Vec::new();
        for entry in &numbered.struck {
            edit.remove(entry);
            replaced.push(Span::new(entry.key.start, entry.value.end));
        }
        for (entry, number) in &numbered.kept {
            if entry.keyword != Keyword::Number(*number) {
                edit.replace(entry.key, &number.to_string())?;
                replaced.push(entry.key);
            }
        }
        for (number, index) in (numbered.listed + 1..).zip(&self.enlisted) {
            let (key, value) = (number.to_string(), format!("0x{index:04X}"));
            match section.entries.last() {
                Some(last) => edit.insert_after(last, &key, &value)?,
                None => edit.insert_first(section, &key, &value)?,
            }
        }
        replaced.extend(self.count(&numbered, section, edit, document)?);
        Ok(replaced)
    }

    /// The lines that can be read come first, as nothing else counts as listed; those that come follow them.
    fn number<'d>(&self, section: &'d Section, document: &Document) -> Numbered<'d> {
        let lines = section
            .entries
            .iter()
            .filter(|entry| matches!(entry.keyword, Keyword::Number(_)));
        let is_struck = |entry: &&Entry| self.struck.binary_search(&entry.value).is_ok();
        let (struck, mut kept): (Vec<&Entry>, Vec<&Entry>) = lines.partition(is_struck);
        kept.sort_by_key(|entry| entry.keyword);
        let is_readable = |entry: &Entry| literal::unsigned(document.text(entry.value), u16::MAX.into()).is_ok();
        let listed = kept.iter().filter(|entry| is_readable(entry)).count();
        let listed = u32::try_from(listed).unwrap_or(u32::MAX);
        let come = u32::try_from(self.enlisted.len()).unwrap_or(u32::MAX);
        let (mut readable, mut unreadable) = (1.., listed.saturating_add(come).saturating_add(1)..);
        let number = |entry: &'d Entry| {
            let number = if is_readable(entry) {
                readable.next()
            } else {
                unreadable.next()
            };
            (entry, number.unwrap_or(u32::MAX))
        };
        let kept = kept.into_iter().map(number).collect();
        Numbered { kept, struck, listed }
    }

    fn count(
        &self,
        numbered: &Numbered<'_>,
        section: &Section,
        edit: &mut Edit<'_>,
        document: &Document,
    ) -> Result<Option<Span>, EditError> {
        let count = numbered.listed as usize + self.enlisted.len();
        let Some(stated) = section.entry(Keyword::SupportedObjects) else {
            edit.insert_first(section, Keyword::SupportedObjects.name(), &count.to_string())?;
            return Ok(None);
        };
        let read = literal::unsigned(document.text(stated.value), u32::MAX.into());
        if read.is_ok_and(|read| read.value == count as u64) {
            return Ok(None);
        }
        let length = u32::try_from(literal::bare(document.text(stated.value)).len()).unwrap_or(0);
        let number = Span::new(stated.value.start, stated.value.start + length);
        edit.replace(number, &count.to_string())?;
        Ok(Some(number))
    }

    /// A list that the file does not have.
    fn write(&self, list: ObjectList, edit: &mut Edit<'_>, document: &Document) -> Result<(), EditError> {
        let count = self.enlisted.len().to_string();
        let lines = (1_u32..).zip(&self.enlisted);
        let lines: Vec<(String, String)> = lines
            .map(|(number, index)| (number.to_string(), format!("0x{index:04X}")))
            .collect();
        let lines = lines.iter().map(|(key, value)| (key.as_str(), value.as_str()));
        let entries: Vec<(&str, &str)> = [(Keyword::SupportedObjects.name(), count.as_str())]
            .into_iter()
            .chain(lines)
            .collect();
        edit.add_section(before(document, list.section_name()), list.section(), &entries)
    }
}

/// The section that a new one stands behind.
pub(super) fn before(document: &Document, new: SectionName) -> Option<&Section> {
    let order = |name: SectionName| name.order(ObjectList::of);
    let known = document
        .sections()
        .iter()
        .filter(|section| section.name != SectionName::Unknown);
    let earlier = known.filter(|section| order(section.name) < order(new));
    earlier.max_by_key(|section| order(section.name))
}

impl ObjectList {
    /// Its section.
    pub(crate) const fn section_name(self) -> SectionName {
        match self {
            Self::Mandatory => SectionName::MandatoryObjects,
            Self::Optional => SectionName::OptionalObjects,
            Self::Manufacturer => SectionName::ManufacturerObjects,
        }
    }

    /// The list that `section` is.
    pub(super) const fn of_section(section: SectionName) -> Option<Self> {
        match section {
            SectionName::MandatoryObjects => Some(Self::Mandatory),
            SectionName::OptionalObjects => Some(Self::Optional),
            SectionName::ManufacturerObjects => Some(Self::Manufacturer),
            _ => None,
        }
    }
}
