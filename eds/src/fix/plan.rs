//! Which fixes go together, and the edit that makes them.

use std::collections::{BTreeMap, BTreeSet};

use super::{
    Change, Fix,
    lists::{ListChange, before},
};
use crate::{
    document::{Document, Edit, EditError, Entry, Keyword, SectionName},
    ir::ObjectList,
    source::{LineEnd, Source},
    span::Span,
};

/// An edit in the making. Of two fixes that want the same text the first is made; the other waits for the next plan.
#[derive(Debug)]
pub(super) struct Plan<'d> {
    document: &'d Document,
    edit: Edit<'d>,
    lists: [Option<ListChange>; 3],
    /// The text that changes: where it starts, where it ends.
    taken: BTreeMap<u32, u32>,
    keywords: BTreeSet<(u32, Keyword)>,
    sections: BTreeSet<SectionName>,
}

impl<'d> Plan<'d> {
    /// Chooses of `fixes` what can be made together.
    pub(super) fn of<'f>(
        document: &'d Document,
        fixes: impl Iterator<Item = &'f Fix> + Clone,
    ) -> Result<Edit<'d>, EditError> {
        let mut plan = Self {
            document,
            edit: document.edit(),
            lists: [None, None, None],
            taken: BTreeMap::new(),
            keywords: BTreeSet::new(),
            sections: BTreeSet::new(),
        };
        for fix in fixes.clone().filter(|fix| fix.is_of_lists()) {
            fix.changes.iter().for_each(|change| plan.list(change));
        }
        plan.make_lists()?;
        for fix in fixes.filter(|fix| !fix.is_of_lists()) {
            if fix.changes.iter().all(|change| plan.is_free(change)) {
                fix.changes.iter().try_for_each(|change| plan.make(change))?;
            }
        }
        Ok(plan.edit)
    }

    /// Changes of lists never stand in each other's way: they are gathered, and each list is written once.
    fn list(&mut self, change: &Change) {
        match *change {
            Change::Enlist { list, index } => self.list_change(list).enlisted.push(index),
            Change::Number { list } => _ = self.list_change(list),
            Change::Strike { at } => {
                let section = self.document.section_around(at);
                if let Some(list) = section.and_then(|section| ObjectList::of_section(section.name)) {
                    self.list_change(list).struck.push(at);
                }
            }
            _ => {}
        }
    }

    fn list_change(&mut self, list: ObjectList) -> &mut ListChange {
        self.lists[list as usize].get_or_insert_default()
    }

    fn make_lists(&mut self) -> Result<(), EditError> {
        for list in [ObjectList::Mandatory, ObjectList::Optional, ObjectList::Manufacturer] {
            let Some(mut change) = self.lists[list as usize].take() else {
                continue;
            };
            for replaced in change.make(list, &mut self.edit, self.document)? {
                self.taken.insert(replaced.start, replaced.end);
            }
        }
        Ok(())
    }

    fn is_free(&self, change: &Change) -> bool {
        match change {
            Change::Replace { at, .. } => self.is_untouched(*at),
            Change::Keyword { header, keyword, .. } => !self.keywords.contains(&(header.start, *keyword)),
            Change::Section { name, .. } => !self.sections.contains(name),
            _ => true,
        }
    }

    fn is_untouched(&self, at: Span) -> bool {
        let before = self.taken.range(..=at.start).next_back();
        let after = self.taken.range(at.start..).next();
        before.is_none_or(|(start, end)| *end <= at.start && *start != at.start)
            && after.is_none_or(|(start, _)| *start >= at.end && *start != at.start)
    }

    fn make(&mut self, change: &Change) -> Result<(), EditError> {
        match change {
            Change::Replace { at, text } => {
                self.taken.insert(at.start, at.end);
                self.edit.replace(*at, text)?;
            }
            Change::Comment { at, text } => self.edit.comment_above(*at, text)?,
            Change::Keyword { header, keyword, value } => {
                self.keywords.insert((header.start, *keyword));
                self.add_keyword(*header, *keyword, value)?;
            }
            Change::Section { name, entries } => {
                self.sections.insert(*name);
                self.add_section(*name, entries)?;
            }
            Change::LineEnds => self.edit.end_lines_with(prevailing_line_end(self.document.source())),
            Change::ByteOrderMark => self.edit.remove_byte_order_mark(),
            Change::Enlist { .. } | Change::Strike { .. } | Change::Number { .. } => {}
        }
        Ok(())
    }

    fn add_keyword(&mut self, header: Span, keyword: Keyword, value: &str) -> Result<(), EditError> {
        let Some(section) = self.document.section_around(header) else {
            return Ok(());
        };
        let key = keyword.spelling().unwrap_or_default();
        let is_before = |entry: &&Entry| entry.keyword.order() < keyword.order();
        match section.entries.iter().rfind(is_before) {
            Some(entry) => self.edit.insert_after(entry, &key, value),
            None => self.edit.insert_first(section, &key, value),
        }
    }

    fn add_section(&mut self, name: SectionName, entries: &[(Keyword, String)]) -> Result<(), EditError> {
        let keys: Vec<String> = entries
            .iter()
            .map(|(keyword, _)| keyword.spelling().unwrap_or_default())
            .collect();
        let values = entries.iter().map(|(_, value)| value.as_str());
        let entries: Vec<(&str, &str)> = keys.iter().map(String::as_str).zip(values).collect();
        let label = name.spelling().unwrap_or_default();
        self.edit.add_section(before(self.document, name), &label, &entries)
    }
}

impl Fix {
    fn is_of_lists(&self) -> bool {
        let of_list = |change: &Change| {
            matches!(
                change,
                Change::Enlist { .. } | Change::Strike { .. } | Change::Number { .. }
            )
        };
        self.changes.iter().all(of_list)
    }
}

/// What most lines end with; CR LF, as the standard has it, where two ends are as frequent.
fn prevailing_line_end(source: &Source) -> LineEnd {
    let mut counts = [(LineEnd::Cr, 0), (LineEnd::Lf, 0), (LineEnd::CrLf, 0)];
    for line in source.lines() {
        let found = LineEnd::of(source.slice(line));
        counts
            .iter_mut()
            .filter(|(end, _)| *end == found)
            .for_each(|(_, count)| *count += 1);
    }
    counts
        .into_iter()
        .max_by_key(|(_, count)| *count)
        .map_or(LineEnd::CrLf, |(end, _)| end)
}
