//! A perfect hash: seeds with which no two entries meet (hash and displace).
//!
//! The functions are those of the runtime's table, which looks entries up by them; its `place` refuses other seeds when
//! the generated code is compiled.

use lexican_eds::ir::Address;

/// Entries a seed, on average. More make the seeds' table smaller and the search for them longer.
const BUCKET: usize = 3;

/// What the runtime needs to find an entry.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Seeds {
    /// One a bucket.
    pub(crate) seeds: Vec<u16>,
    /// How many places the table has; some stay empty.
    pub(crate) places: usize,
}

impl Seeds {
    /// Seeds for `addresses`, no address twice.
    pub(crate) fn search(addresses: &[Address]) -> Self {
        let buckets = addresses.len().div_ceil(BUCKET).max(1);
        let mut places = addresses.len() + addresses.len() / 24 + 1;
        loop {
            match fill(addresses, buckets, places) {
                Some(seeds) => return Self { seeds, places },
                // One more empty place makes it easier; with very many there is always a way.
                None => places += 1 + places / 64,
            }
        }
    }
}

/// A seed for each bucket, the fullest bucket first, while most places are free.
fn fill(addresses: &[Address], buckets: usize, places: usize) -> Option<Vec<u16>> {
    let mut keys = vec![Vec::new(); buckets];
    for &address in addresses {
        let key = lookup_key(address);
        keys.get_mut(scale(key, buckets))?.push(key);
    }
    let mut order: Vec<usize> = (0..buckets).collect();
    order.sort_by_key(|&bucket| std::cmp::Reverse(keys[bucket].len()));
    let mut seeds = vec![0; buckets];
    let mut taken = vec![false; places];
    for bucket in order {
        seeds[bucket] = (0..=u16::MAX).find(|&seed| take(&keys[bucket], seed, &mut taken))?;
    }
    Some(seeds)
}

/// Takes the places of `keys` with `seed`, all of them or none.
fn take(keys: &[u32], seed: u16, taken: &mut [bool]) -> bool {
    for (count, &key) in keys.iter().enumerate() {
        let place = slot(key, seed, taken.len());
        if taken[place] {
            for &key in &keys[..count] {
                taken[slot(key, seed, taken.len())] = false;
            }
            return false;
        }
        taken[place] = true;
    }
    true
}

fn lookup_key(address: Address) -> u32 {
    (u32::from(address.index) << 8 | u32::from(address.sub)).wrapping_mul(0x9E37_79B1)
}

/// `hash` scaled to `0..length`.
fn scale(hash: u32, length: usize) -> usize {
    ((u64::from(hash) * length as u64) >> 32) as usize
}

fn slot(key: u32, seed: u16, places: usize) -> usize {
    scale((key ^ u32::from(seed)).wrapping_mul(0x85EB_CA6B), places)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use lexican_eds::ir::Address;

    use super::{Seeds, lookup_key, scale, slot};

    fn places_of(addresses: &[Address]) -> (Seeds, BTreeSet<usize>) {
        let seeds = Seeds::search(addresses);
        let place = |&address: &Address| {
            let key = lookup_key(address);
            slot(key, seeds.seeds[scale(key, seeds.seeds.len())], seeds.places)
        };
        let places = addresses.iter().map(place).collect();
        (seeds, places)
    }

    #[test]
    fn no_two_entries_meet_in_dictionaries_of_any_size() {
        for length in [0, 1, 2, 3, 5, 64, 1000, 20_000] {
            let addresses: Vec<Address> = (0..length)
                .map(|n: u32| Address::new(0x1000 + u16::try_from(n / 100).unwrap(), u8::try_from(n % 100).unwrap()))
                .collect();
            let (seeds, places) = places_of(&addresses);
            assert_eq!(places.len(), addresses.len(), "{length}");
            assert!(
                seeds.places <= addresses.len() * 110 / 100 + 8,
                "{length}: {}",
                seeds.places
            );
        }
    }
}
