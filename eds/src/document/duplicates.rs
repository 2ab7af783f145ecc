//! Sections and keywords that stand twice.

use super::{Entry, Keyword, Problem, Section, SectionName};
use crate::source::Source;
use crate::span::Span;

/// Every section whose name, and every entry whose keyword in its section, was there before.
pub(super) fn find(source: &Source, sections: &[Section]) -> Vec<Problem> {
    let known = sections.iter().filter(|section| section.name != SectionName::Unknown);
    let unknown = sections.iter().filter(|section| section.name == SectionName::Unknown);
    let of_sections = repeated(known.map(|section| (section.name, section.label)))
        .into_iter()
        .chain(repeated(
            unknown.map(|section| (folded(source, section.label), section.label)),
        ))
        .map(|(first, at)| Problem::DuplicateSection { at, first });
    let of_entries = sections
        .iter()
        .filter(|section| !ascending(&section.entries))
        .flat_map(|section| repeated_keywords(source, &section.entries))
        .map(|(first, at)| Problem::DuplicateKeyword { at, first });
    of_sections.chain(of_entries).collect()
}

/// Whether each keyword comes after the one before it in the order of [`Keyword`]: then none stands twice.
fn ascending(entries: &[Entry]) -> bool {
    entries.is_sorted_by(|one, next| one.keyword < next.keyword)
}

fn repeated_keywords(source: &Source, entries: &[Entry]) -> Vec<(Span, Span)> {
    let known = entries.iter().filter(|entry| entry.keyword != Keyword::Unknown);
    let unknown = entries.iter().filter(|entry| entry.keyword == Keyword::Unknown);
    let mut found = repeated(known.map(|entry| (entry.keyword, entry.key)));
    found.extend(repeated(unknown.map(|entry| (folded(source, entry.key), entry.key))));
    found
}

/// An unknown name, in lower case.
fn folded(source: &Source, name: Span) -> String {
    source.slice(name).to_lowercase()
}

/// The places of names that were there before, each after the place where it was first.
fn repeated<T: Ord>(names: impl Iterator<Item = (T, Span)>) -> Vec<(Span, Span)> {
    let mut names: Vec<(T, Span)> = names.collect();
    names.sort();
    names
        .chunk_by(|(one, _), (next, _)| one == next)
        .filter_map(<[_]>::split_first)
        .flat_map(|((_, first), others)| others.iter().map(|(_, other)| (*first, *other)))
        .collect()
}
