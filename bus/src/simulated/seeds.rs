//! The seeds of a perfect hash, as [`Table::find`](lexican_runtime::od::Table::find) wants them.

use std::cmp::Reverse;

use lexican_runtime::od::{Entry, bucket_of, place_of};

/// A table: the entries on their places, and the seeds of its buckets.
pub(super) type Placed = (Vec<Entry>, Vec<u16>);

/// Lays `entries` out, no two of which have the same address. Where no seeds are found there is more room in the next try:
/// that is seldom, and costs a few empty places.
pub(super) fn place(entries: &[Entry]) -> Placed {
    let mut places = entries.len() + entries.len() / 32 + 1;
    loop {
        if let Some(placed) = place_in(entries, places) {
            return placed;
        }
        places += places / 8 + 1;
    }
}

/// Finds for the fullest bucket first the least seed that puts all its entries on free places.
fn place_in(entries: &[Entry], places: usize) -> Option<Placed> {
    let mut table = vec![Entry::EMPTY; places];
    let mut seeds = vec![0; entries.len() / 3 + 1];
    let mut buckets: Vec<Vec<Entry>> = vec![Vec::new(); seeds.len()];
    for entry in entries {
        buckets.get_mut(bucket_of(entry.address(), seeds.len()))?.push(*entry);
    }
    let mut order: Vec<(usize, Vec<Entry>)> = buckets.into_iter().enumerate().collect();
    order.sort_by_key(|(_, entries)| Reverse(entries.len()));
    for (bucket, entries) in order {
        let is_placed = (0..=u16::MAX).any(|seed| try_seed(&mut table, &mut seeds, (bucket, seed), &entries));
        if !is_placed {
            return None;
        }
    }
    Some((table, seeds))
}

/// Puts the entries of a bucket on their places, if `seed` gives them free ones.
fn try_seed(table: &mut [Entry], seeds: &mut [u16], (bucket, seed): (usize, u16), entries: &[Entry]) -> bool {
    let Some(own) = seeds.get_mut(bucket) else { return false };
    *own = seed;
    for (count, entry) in entries.iter().enumerate() {
        let place = place_of(entry.address(), seeds, table.len());
        match table.get_mut(place) {
            Some(free) if *free == Entry::EMPTY => *free = *entry,
            _ => {
                clear(table, seeds, entries.get(..count).unwrap_or_default());
                return false;
            }
        }
    }
    true
}

fn clear(table: &mut [Entry], seeds: &[u16], entries: &[Entry]) {
    for entry in entries {
        let place = place_of(entry.address(), seeds, table.len());
        if let Some(taken) = table.get_mut(place) {
            *taken = Entry::EMPTY;
        }
    }
}

#[cfg(test)]
mod tests {
    use lexican_runtime::od::{Access, DataType, Table};

    use super::*;

    fn entry(index: u16, sub: u8) -> Entry {
        Entry::new(index, sub, DataType::UNSIGNED8, Access::READ, 0)
    }

    #[track_caller]
    fn hold(entries: &[Entry]) {
        let (places, seeds) = place(entries);
        let table = Table {
            entries: &places,
            seeds: &seeds,
            extras: &[],
            constants: &[],
        };
        for entry in entries {
            assert_eq!(table.find(entry.address()), Some(*entry));
        }
    }

    #[test]
    fn every_entry_of_small_dictionaries_is_found_whatever_their_addresses() {
        let mut random = 1_u32;
        for round in 0..3000 {
            let mut entries: Vec<Entry> = (0..round % 40)
                .map(|_| {
                    random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    let [_, sub, low, high] = random.to_le_bytes();
                    entry(u16::from_le_bytes([low, high]), sub)
                })
                .collect();
            entries.sort_by_key(|entry| (entry.index, entry.sub));
            entries.dedup_by_key(|entry| (entry.index, entry.sub));
            hold(&entries);
        }
    }

    #[test]
    fn every_entry_of_large_dictionaries_is_found() {
        hold(&(0..=254).map(|sub| entry(0x2000, sub)).collect::<Vec<_>>());
        hold(&(0x2000..0x4710).map(|index| entry(index, 0)).collect::<Vec<_>>());
    }
}
