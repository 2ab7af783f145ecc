//! What the builder was told, held against the file.

use lexican_eds::ir::{Dictionary, Entry, Object};

use crate::{
    Error, Selector,
    emit::facts::quoted,
    plan::{Options, Plan, is_string},
};

/// Offsets into values and constants have 16 bits.
const REACH: usize = 0x1_0000;

/// Whether every object that the builder names is there, and can be what the builder has it be.
pub(crate) fn selectors(dictionary: &Dictionary, file: &str, options: &Options) -> Result<(), Error> {
    let Options {
        reads,
        writes,
        streams,
        capacities,
    } = options;
    let strings: Vec<Selector> = capacities.iter().map(|&(selector, _)| selector).collect();
    for &selector in reads.iter().chain(writes).chain(streams).chain(&strings) {
        if selector.values(dictionary).next().is_none() {
            return Err(missing(dictionary, file, selector));
        }
    }
    let without = |selectors: &[Selector], wanted: fn(&Entry) -> bool| {
        let mut selectors = selectors.iter().copied();
        selectors.find(|selector| !selector.values(dictionary).any(wanted))
    };
    let file = file.to_owned();
    let one_way = |some: &[Selector], others: &[Selector]| -> Vec<Selector> {
        some.iter()
            .copied()
            .filter(|selector| !others.contains(selector))
            .collect()
    };
    if let Some(selector) = without(&one_way(reads, writes), |entry| entry.access.readable()) {
        return Err(Error::NotReadable { selector, file });
    }
    if let Some(selector) = without(&one_way(writes, reads), |entry| entry.access.writable()) {
        return Err(Error::NotWritable { selector, file });
    }
    if let Some(selector) = without(streams, |entry| is_string(entry.data_type)) {
        return Err(Error::NotStreamed { selector, file });
    }
    match without(&strings, |entry| is_string(entry.data_type)) {
        Some(selector) => Err(Error::NotAString { selector, file }),
        None => Ok(()),
    }
}

/// Whether the runtime's table reaches everything.
pub(crate) fn size(plan: &Plan<'_>) -> Result<(), Error> {
    let [values, constants] = [plan.size(), plan.pool.len()];
    if values <= REACH && constants <= REACH {
        return Ok(());
    }
    Err(Error::TooLarge {
        file: plan.file.to_owned(),
        values,
        constants,
    })
}

fn missing(dictionary: &Dictionary, file: &str, selector: Selector) -> Error {
    let near = match (dictionary.object(selector.index()), selector) {
        (Some(object), Selector::Value(_, sub)) => near_sub_indices(object, sub),
        _ => near_objects(dictionary, selector.index()),
    };
    let file = file.to_owned();
    Error::NoSuchObject { selector, file, near }
}

fn near_sub_indices(object: &Object, sub: u8) -> Vec<String> {
    let entries = nearest(&object.entries, |entry| entry.address.sub.abs_diff(sub));
    let title = |entry: &Entry| format!("{} {}", entry.address, quoted(&entry.name));
    entries.into_iter().map(title).collect()
}

fn near_objects(dictionary: &Dictionary, index: u16) -> Vec<String> {
    let objects = nearest(&dictionary.objects, |object| object.index.abs_diff(index));
    let title = |object: &Object| format!("{:04X}h {}", object.index, quoted(&object.name));
    objects.into_iter().map(title).collect()
}

/// The three of `sorted` that are least far, in their order.
fn nearest<T, D: Ord>(sorted: &[T], distance: impl Fn(&T) -> D) -> Vec<&T> {
    let mut numbers: Vec<usize> = (0..sorted.len()).collect();
    numbers.sort_by_key(|&number| distance(&sorted[number]));
    numbers.truncate(3);
    numbers.sort_unstable();
    numbers.into_iter().map(|number| &sorted[number]).collect()
}
