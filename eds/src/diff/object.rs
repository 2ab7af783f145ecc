//! The objects of both devices.

use std::collections::BTreeSet;

use super::{Difference, Effect, Subject, entry, goes};
use crate::{
    ir::{Dictionary, Entry, Object, ObjectCode, ObjectList},
    span::Span,
};

/// Adds what differs between the objects of `old` and `new`, by index and sub-index.
pub(super) fn compare(old: &Dictionary, new: &Dictionary, found: &mut Vec<Difference>) {
    let indices = |dictionary: &Dictionary| dictionary.objects.iter().map(|object| object.index).collect();
    let (before, after): (BTreeSet<u16>, BTreeSet<u16>) = (indices(old), indices(new));
    for index in before.union(&after) {
        match (old.object(*index), new.object(*index)) {
            (Some(old), Some(new)) => object(old, new, found),
            (Some(old), None) => found.push(whole(title(old), &old.name, Some(old.span), None)),
            (None, Some(new)) => found.push(whole(title(new), &new.name, None, Some(new.span))),
            (None, None) => {}
        }
    }
}

fn object(old: &Object, new: &Object, found: &mut Vec<Difference>) {
    let subject = Subject {
        title: title(new),
        name: new.name.clone(),
    };
    let single = is_single(old) && is_single(new);
    let code = |object: &Object| object.code.name();
    let code = subject.fact(
        "ObjectType",
        (code(old), code(new)),
        |name| Some(name.to_owned()),
        Effect::Breaking,
    );
    // The one value of a single object has its name.
    let names = (!single).then(|| {
        let names = (&old.name, &new.name);
        subject.fact(
            "ParameterName",
            names,
            |name: &String| Some(name.clone()),
            Effect::Cosmetic,
        )
    });
    let list = |object: &Object| object.list.map(ObjectList::section);
    let list = subject.fact(
        "list",
        (list(old), list(new)),
        |list: Option<&str>| list.map(str::to_owned),
        Effect::Cosmetic,
    );
    let links = |links: &Vec<u16>| {
        let links = links.iter().map(|index| format!("{index:04X}"));
        Some(links.collect::<Vec<_>>().join(" ")).filter(|links| !links.is_empty())
    };
    let links = subject.fact("ObjectLinks", (&old.links, &new.links), links, Effect::Cosmetic);
    let facts = [code, names.flatten(), list, links].into_iter().flatten();
    found.extend(facts.map(|difference| difference.at(old.span, new.span)));
    entries(old, new, single, found);
}

fn entries(old: &Object, new: &Object, single: bool, found: &mut Vec<Difference>) {
    let subs = |object: &Object| object.entries.iter().map(|entry| entry.address.sub).collect();
    let (before, after): (BTreeSet<u8>, BTreeSet<u8>) = (subs(old), subs(new));
    let section = |entry: &Entry| Some(entry.spans.section);
    for sub in before.union(&after) {
        match (old.entry(*sub), new.entry(*sub)) {
            (Some(one), Some(other)) => {
                let title = if single { title(new) } else { other.address.to_string() };
                entry::compare(title, one, other, found);
            }
            (Some(gone), None) => found.push(whole(gone.address.to_string(), &gone.name, section(gone), None)),
            (None, Some(come)) => found.push(whole(come.address.to_string(), &come.name, None, section(come))),
            (None, None) => {}
        }
    }
}

/// Something that is in one of the devices only.
fn whole(subject: String, name: &str, old: Option<Span>, new: Option<Span>) -> Difference {
    Difference {
        effect: goes(old.is_some()),
        before: old.map(|_| subject.clone()),
        after: new.map(|_| subject.clone()),
        subject,
        name: name.to_owned(),
        fact: None,
        old,
        new,
    }
}

fn title(object: &Object) -> String {
    format!("{:04X}", object.index)
}

const fn is_single(object: &Object) -> bool {
    !matches!(
        object.code,
        ObjectCode::Array | ObjectCode::Record | ObjectCode::DefStruct
    )
}
