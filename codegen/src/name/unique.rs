//! One name for each generated item.

use std::collections::{BTreeMap, BTreeSet};

use lexican_eds::ir::{Address, Object};

use super::ident::{cut, letter_first, snake};

/// A thing to be named: a value, or the elements of an array.
#[derive(Clone, Copy)]
pub(crate) struct Named<'a> {
    /// The object that it belongs to.
    pub(crate) object: &'a Object,
    /// Its address; of an array's elements the first one's.
    pub(crate) address: Address,
    /// The EDS's name for the sub-index; `None` where the object's name says all.
    pub(crate) sub_name: Option<&'a str>,
}

/// What an object or a sub-index may not be called, because the generated struct has it already.
const TAKEN: [&str; 1] = ["defaults"];

/// A name in snake case for each of `items`, no two the same.
pub(crate) fn unique_names(items: &[Named<'_>]) -> Vec<String> {
    let objects = object_names(items);
    let subs = sub_names(items);
    let bases: Vec<String> = items
        .iter()
        .zip(subs)
        .map(|(item, sub)| letter_first(join(&objects[&item.object.index], sub)))
        .collect();
    with_addresses(items, &bases)
}

/// The objects' names, those that are not their own with the index behind them.
fn object_names(items: &[Named<'_>]) -> BTreeMap<u16, String> {
    let objects: BTreeMap<u16, &str> = items
        .iter()
        .map(|item| (item.object.index, item.object.name.as_str()))
        .collect();
    let names: Vec<(String, bool)> = objects.values().map(|name| cut(snake(name))).collect();
    let several = repeated(names.iter().map(|(name, _)| name));
    let pairs = objects.into_keys().zip(&names).map(|(index, (name, was_cut))| {
        let name = match name.as_str() {
            "" => format!("object_{index:04x}"),
            name if *was_cut || several.contains(name) || TAKEN.contains(&name) => format!("{name}_{index:04x}"),
            name => name.to_owned(),
        };
        (index, name)
    });
    pairs.collect()
}

/// The sub-indices' names, those that are not their own in the object with the number behind them.
fn sub_names(items: &[Named<'_>]) -> Vec<Option<String>> {
    let names: Vec<Option<(String, bool)>> = items
        .iter()
        .map(|item| item.sub_name.map(|name| cut(snake(name))))
        .collect();
    let within = |(item, name): (&Named<'_>, &Option<(String, bool)>)| {
        name.as_ref().map(|(name, _)| (item.object.index, name.clone()))
    };
    let several = repeated_values(items.iter().zip(&names).filter_map(within));
    let numbered = items.iter().zip(names).map(|(item, name)| {
        let sub = item.address.sub;
        name.map(|(name, was_cut)| match name.as_str() {
            "" => format!("sub{sub:x}"),
            _ if was_cut || several.contains(&(item.object.index, name.clone())) => format!("{name}_sub{sub:x}"),
            _ => name,
        })
    });
    numbered.collect()
}

/// `object_sub`; `sub` alone where it repeats the object's name.
fn join(object: &str, sub: Option<String>) -> String {
    match sub {
        None => object.to_owned(),
        Some(sub) if sub.strip_prefix(object).is_some_and(|rest| rest.starts_with('_')) => sub,
        Some(sub) => format!("{object}_{sub}"),
    }
}

/// The names, those that still meet another with their address behind them.
fn with_addresses(items: &[Named<'_>], bases: &[String]) -> Vec<String> {
    let mut names = bases.to_vec();
    // A name with its address may in turn meet a name that looks the same by nature; then that one gets its address
    // too. Once all have theirs, no two are the same.
    loop {
        let several = repeated(names.iter());
        if several.is_empty() {
            return names;
        }
        for (name, (item, base)) in names.iter_mut().zip(items.iter().zip(bases)) {
            if several.contains(name.as_str()) {
                let Address { index, sub } = item.address;
                *name = format!("{base}_{index:04x}sub{sub:x}");
            }
        }
    }
}

/// What is in `values` more than once.
fn repeated<'a>(values: impl Iterator<Item = &'a String>) -> BTreeSet<String> {
    repeated_values(values.cloned())
}

fn repeated_values<T: Ord + Clone>(values: impl Iterator<Item = T>) -> BTreeSet<T> {
    let mut seen = BTreeSet::new();
    values.filter(|value| !seen.insert(value.clone())).collect()
}
