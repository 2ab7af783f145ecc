//! CompactSubObj and its lists (CiA 306-1, 4.5.4): sub-objects without sections of their own.

use super::{Lowering, Problem, entry};
use crate::ir::{Address, Entry};
use crate::model::{self, Description, Item, List};
use crate::span::Spanned;

/// The highest sub-index: 255 is kept for the structure of the object (CiA 301, 7.4.7).
const HIGHEST: u8 = 254;

/// The values of all sub-objects, with section or without, sorted by sub-index.
pub(super) fn expand(object: &model::Object, lowering: &mut Lowering) -> Vec<Entry> {
    let mut subs = object.subs.iter().peekable();
    let mut entries = Vec::new();
    if let Some((description, count)) = compact_form(object, lowering) {
        let highest = highest(object.index, count, lowering);
        entries.reserve(usize::from(highest) + 1);
        for sub in 0..=highest {
            entries.push(match subs.next_if(|described| described.sub == sub) {
                Some(sub) => described(object, sub, lowering),
                None if sub == 0 => entry::sub_zero(object.index, highest, count.span),
                None => undescribed(object.index, sub, description, lowering),
            });
        }
    }
    entries.extend(subs.map(|sub| described(object, sub, lowering)));
    entries
}

/// CompactSubObj and the description that it repeats, if there are such sub-objects and room for them.
fn compact_form<'o>(object: &'o model::Object, lowering: &mut Lowering) -> Option<(&'o Description, Spanned<u16>)> {
    let description = object.description.as_ref()?;
    let count = description.compact_sub_obj.filter(|count| count.value != 0)?;
    if lowering.take_room(usize::from(count.value.min(u16::from(HIGHEST)))) {
        return Some((description, count));
    }
    lowering.report(Problem::TooManyValues {
        index: object.index,
        at: count.span,
    });
    None
}

fn highest(index: u16, count: Spanned<u16>, lowering: &mut Lowering) -> u8 {
    u8::try_from(count.value)
        .ok()
        .filter(|&count| count <= HIGHEST)
        .unwrap_or_else(|| {
            lowering.report(Problem::TooManySubs { index, at: count.span });
            HIGHEST
        })
}

fn described(object: &model::Object, sub: &model::Sub, lowering: &mut Lowering) -> Entry {
    // An orphan inherits nothing, but its sub-index 0 is one.
    let nothing = Description::default();
    let parent = object.description.as_ref().unwrap_or(&nothing);
    entry::lower(
        Address::new(object.index, sub.sub),
        &sub.description,
        Some(parent),
        lowering,
    )
}

/// A sub-object of the compact form: as the object, its name with the sub-index behind it.
///
/// What the object's section lacks is reported once, for the first of them.
fn undescribed(index: u16, sub: u8, description: &Description, lowering: &mut Lowering) -> Entry {
    let reported = lowering.problems.len();
    let mut entry = entry::lower(Address::new(index, sub), description, None, lowering);
    if sub > 1 {
        lowering.problems.truncate(reported);
    }
    entry.name.push_str(&sub.to_string());
    entry
}

/// Puts the lines of `[xxxxName]`, `[xxxxValue]` and `[xxxxDenotation]` into the sub-objects.
///
/// What a section of the sub-object itself says comes first.
pub(super) fn apply_lists(object: &model::Object, entries: &mut [Entry], lowering: &mut Lowering) {
    let has_section = |entry: &Entry| object.sub(entry.address.sub).is_some();
    apply(object.names.as_deref(), entries, lowering, |entry, name| {
        if !has_section(entry) {
            entry.name.clone_from(&name.value);
            entry.spans.name = name.span;
        }
    });
    apply(object.values.as_deref(), entries, lowering, |entry, value| {
        if !entry.configured {
            entry.default = Some(value.value.clone());
            entry.configured = true;
            entry.spans.default = value.span;
        }
    });
    apply(object.denotations.as_deref(), entries, lowering, |entry, denotation| {
        entry.denotation.get_or_insert_with(|| denotation.value.clone());
    });
}

fn apply<T>(
    list: Option<&List<T>>,
    entries: &mut [Entry],
    lowering: &mut Lowering,
    set: impl Fn(&mut Entry, &Spanned<T>),
) {
    let Some(index) = entries.first().map(|entry| entry.address.index) else {
        return;
    };
    for Item { number, value } in list.into_iter().flat_map(|list| &list.items) {
        let place = entries.binary_search_by_key(&number.value, |entry| entry.address.sub.into());
        match place.ok().and_then(|place| entries.get_mut(place)) {
            Some(entry) => set(entry, value),
            None => lowering.report(Problem::LineOfNoSub {
                index,
                number: number.value,
                at: number.span,
            }),
        }
    }
}
