//! Numbered lines: object lists, compact forms, modules.

use super::field::{Fields, Unsigned, first};
use crate::document::{Entry, Keyword, Section};
use crate::span::{Span, Spanned};

/// A section of numbered lines: `NrOfEntries=2`, `1=…`, `2=…`.
#[derive(Clone, Debug)]
pub struct List<T> {
    /// The section's header.
    pub header: Span,
    /// How many lines the file says there are: SupportedObjects, NrOfEntries, ObjectLinks.
    pub count: Option<Spanned<u32>>,
    /// The lines in the order of the file.
    pub items: Vec<Item<T>>,
}

/// A line of a list.
#[derive(Clone, Debug)]
pub struct Item<T> {
    /// The number before the `=`, and where it stands.
    pub number: Spanned<u32>,
    /// What is listed.
    pub value: Spanned<T>,
}

/// Reads a list whose length is given by `count`, and each line by `item`.
pub(super) fn read<'d, T>(
    fields: &mut Fields<'d>,
    section: &Section,
    count: Keyword,
    item: impl Fn(&mut Fields<'d>, &Entry) -> Option<Spanned<T>>,
) -> List<T> {
    let mut list = List {
        header: section.header,
        count: None,
        items: Vec::new(),
    };
    for entry in &section.entries {
        match entry.keyword {
            Keyword::Number(number) => {
                let number = Spanned::new(number, entry.key);
                list.items
                    .extend(item(fields, entry).map(|value| Item { number, value }));
            }
            keyword if keyword == count => first(&mut list.count, fields.number(entry)),
            _ => fields.misplaced(entry),
        }
    }
    list
}

/// Reads a list of numbers.
pub(super) fn read_numbers<T: Unsigned>(fields: &mut Fields<'_>, section: &Section, count: Keyword) -> List<T> {
    read(fields, section, count, Fields::number)
}

impl<T> List<T> {
    /// The listed values, in the order of the file.
    pub fn values(&self) -> impl Iterator<Item = &Spanned<T>> {
        self.items.iter().map(|item| &item.value)
    }
}
