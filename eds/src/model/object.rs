//! An object with all its sections.

use super::description::{self, Description};
use super::field::Fields;
use super::list::{self, List};
use crate::document::{Keyword, Section, SectionName};
use crate::ir::{DataType, Value};
use crate::span::{Span, Spanned};

/// The sections of one index: `[1018]`, `[1018sub0]` …, `[1018Name]` ….
#[derive(Clone, Debug, Default)]
pub struct Object {
    /// The index.
    pub index: u16,
    /// `[xxxx]`; `None` when only other sections of the object are there.
    pub description: Option<Description>,
    /// `[xxxxsubN]`, sorted by sub-index.
    pub subs: Vec<Sub>,
    /// `[xxxxName]`: names of sub-objects without section.
    pub names: Option<Box<List<String>>>,
    /// `[xxxxValue]`: values of sub-objects without section.
    pub values: Option<Box<List<Value>>>,
    /// `[xxxxDenotation]`: denotations of sub-objects without section.
    pub denotations: Option<Box<List<String>>>,
    /// `[xxxxObjectLinks]`
    pub links: Option<Box<List<u16>>>,
}

/// A sub-object: `[1018sub1]`.
#[derive(Clone, Debug, Default)]
pub struct Sub {
    /// The sub-index.
    pub sub: u8,
    /// What the section says.
    pub description: Description,
}

impl Object {
    /// The sub-object at `sub`.
    #[must_use]
    pub fn sub(&self, sub: u8) -> Option<&Sub> {
        let at = self.subs.binary_search_by_key(&sub, |candidate| candidate.sub).ok()?;
        self.subs.get(at)
    }

    /// The header of the object's section; without one, that of the first section of the object.
    #[must_use]
    pub fn header(&self) -> Span {
        let description = self
            .description
            .as_ref()
            .or(self.subs.first().map(|sub| &sub.description));
        let lists = [&self.names, &self.denotations];
        description
            .map(|description| description.header)
            .or(lists.into_iter().flatten().map(|list| list.header).next())
            .or(self.values.as_ref().map(|list| list.header))
            .or(self.links.as_ref().map(|list| list.header))
            .unwrap_or_default()
    }

    /// Reads one more section of the object. The sections come in the order of [`SectionName`].
    pub(super) fn read(&mut self, fields: &mut Fields<'_>, section: &Section) {
        match section.name {
            SectionName::Object(_) => self.description = Some(read_description(fields, section, None)),
            SectionName::Sub(_, sub) => {
                let description = read_description(fields, section, self.sub_type(sub));
                self.subs.push(Sub { sub, description });
            }
            SectionName::Name(_) => self.names = Some(Box::new(read_texts(fields, section))),
            SectionName::Denotation(_) => self.denotations = Some(Box::new(read_texts(fields, section))),
            SectionName::Value(_) => self.values = Some(Box::new(self.read_values(fields, section))),
            SectionName::ObjectLinks(_) => {
                self.links = Some(Box::new(list::read_numbers(fields, section, Keyword::ObjectLinks)));
            }
            _ => {}
        }
    }

    /// The type of a sub-object that has no DataType: sub-index 0 is UNSIGNED8 (CiA 301, 7.4.3), the others are of the
    /// object's type.
    pub(super) fn sub_type(&self, sub: u8) -> Option<u16> {
        match sub {
            0 => Some(DataType::Unsigned8.index()),
            _ => self.description.as_ref()?.data_type.map(|data_type| data_type.value),
        }
    }

    /// The values of sub-objects, each by its own type.
    fn read_values(&self, fields: &mut Fields<'_>, section: &Section) -> List<Value> {
        list::read(fields, section, Keyword::NrOfEntries, |fields, entry| {
            let Keyword::Number(number) = entry.keyword else {
                return None;
            };
            let sub = u8::try_from(number).unwrap_or(u8::MAX);
            let described = self.sub(sub).map(|sub| sub.description.value_type());
            let data_type = described.unwrap_or_else(|| self.sub_type(sub));
            fields.value(entry, data_type)
        })
    }
}

/// The last object, if it is the one with `index`, else a new one: sections come sorted.
pub(super) fn last_or_new(objects: &mut Vec<Object>, index: u16) -> &mut Object {
    if objects.last().is_none_or(|last| last.index != index) {
        objects.push(Object {
            index,
            ..Object::default()
        });
    }
    let last = objects.len() - 1;
    &mut objects[last]
}

pub(super) fn read_description(fields: &mut Fields<'_>, section: &Section, fallback: Option<u16>) -> Description {
    description::read(fields, section, fallback, Fields::misplaced)
}

fn read_texts(fields: &mut Fields<'_>, section: &Section) -> List<String> {
    list::read(
        fields,
        section,
        Keyword::NrOfEntries,
        |fields, entry| -> Option<Spanned<String>> { fields.text(entry) },
    )
}
