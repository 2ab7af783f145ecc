//! The table of entries, found by a perfect hash: the same few instructions for ten objects and for ten thousand.
//!
//! The hash is "hash and displace": an address falls into a bucket, the bucket's seed says on which place. A generator
//! looks for the seeds, the fullest bucket first, and each the least with which all entries of the bucket fall on places
//! that are still free. With a third as many seeds as entries, and a place in 32 left empty, that takes a few thousand
//! tries for any bucket, of 100 entries or of 10,000, and the whole costs 8.9 bytes an entry.

use super::{Access, Entry, Extra, Row};
use crate::Address;

/// A dictionary's description. Generated ones stand in flash; a simulated one may own its parts.
#[derive(Clone, Copy, Debug)]
pub struct Table<'a> {
    /// The entries, placed by [`place`].
    pub entries: &'a [Entry],
    /// One seed a bucket; the generator chose them so that no two entries meet.
    pub seeds: &'a [u16],
    /// Strings and limits.
    pub extras: &'a [Extra],
    /// Values of const objects, and limits. Numbers are little-endian and as wide as in the struct
    /// ([`DataType::width`](super::DataType::width)), at any offset; strings are their bytes.
    pub constants: &'a [u8],
}

/// First mixing step of the hash: spreads `index << 8 | sub` over 32 bits, one to one.
#[must_use]
pub const fn lookup_key(address: Address) -> u32 {
    address.key().wrapping_mul(0x9E37_79B1)
}

/// `hash` scaled to `0..length`.
const fn scale(hash: u32, length: usize) -> usize {
    ((hash as u64 * length as u64) >> 32) as usize
}

/// The bucket whose seed places `key`.
const fn bucket(key: u32, seeds: usize) -> usize {
    scale(key, seeds)
}

/// The place of `key` among `entries` places, given its bucket's seed.
const fn slot(key: u32, seed: u16, entries: usize) -> usize {
    scale((key ^ seed as u32).wrapping_mul(0x85EB_CA6B), entries)
}

/// Lays `rows` out for [`Table::find`], at compile time.
///
/// # Panics
/// At compile time only, when `seeds` were not made for these rows.
#[must_use]
pub const fn place<const PLACES: usize>(rows: &[Row], seeds: &[u16]) -> [Entry; PLACES] {
    let mut placed = [Entry::EMPTY; PLACES];
    let mut row = 0;
    while row < rows.len() {
        let mut nth = 0;
        while nth < rows[row].values() {
            let entry = rows[row].entry(nth);
            let at = place_of(entry.address(), seeds, PLACES);
            assert!(placed[at].data_type.0 == 0, "these seeds were made for other rows");
            placed[at] = entry;
            nth += 1;
        }
        row += 1;
    }
    placed
}

/// The bucket, and so the seed, of `address` in a table with so many seeds.
#[must_use]
pub const fn bucket_of(address: Address, seeds: usize) -> usize {
    bucket(lookup_key(address), seeds)
}

/// The place of `address` in a table with these seeds and so many places.
///
/// A generator that looks for seeds asks this for every entry of a bucket, until it knows a seed with which all of them
/// fall on free places.
#[must_use]
pub const fn place_of(address: Address, seeds: &[u16], places: usize) -> usize {
    let key = lookup_key(address);
    slot(key, seeds[bucket(key, seeds.len())], places)
}

impl Table<'_> {
    /// The entry at `address`, if the dictionary has one.
    #[must_use]
    pub fn find(&self, address: Address) -> Option<Entry> {
        let key = lookup_key(address);
        let seed = *self.seeds.get(bucket(key, self.seeds.len()))?;
        let entry = *self.entries.get(slot(key, seed, self.entries.len()))?;
        // An empty place has the address 0000h:00, which a client may ask for.
        (entry.index == address.index && entry.sub == address.sub && entry.data_type.0 != 0).then_some(entry)
    }

    /// Where in [`Table::entries`] the one at `address` stands, if the dictionary has one.
    pub(crate) fn position(&self, address: Address) -> Option<usize> {
        let key = lookup_key(address);
        let seed = *self.seeds.get(bucket(key, self.seeds.len()))?;
        let place = slot(key, seed, self.entries.len());
        let entry = self.entries.get(place)?;
        (entry.address() == address && entry.data_type.0 != 0).then_some(place)
    }

    /// How many sub-indices the object at `index` has that follow one another, from 1 on.
    #[inline(never)] // Seldom asked.
    pub(crate) fn elements(&self, index: u16) -> u8 {
        let mut count = 0;
        while count < 254 && self.find(Address::new(index, count + 1)).is_some() {
            count += 1;
        }
        count
    }

    /// Where the value of `entry` stands, and the [`Extra::detail`] of it (0 where it has none); `None` for an entry that
    /// is not of this table.
    pub(crate) fn locate(&self, entry: Entry) -> Option<(usize, usize)> {
        if !entry.access.has(Access::EXTRA) {
            return Some((usize::from(entry.slot), 0));
        }
        let extra = self.extras.get(usize::from(entry.slot))?;
        Some((usize::from(extra.slot), usize::from(extra.detail)))
    }

    /// Whether any sub-index of `index` exists. Slow: walks the table; only a refused access asks.
    #[must_use]
    pub fn has_object(&self, index: u16) -> bool {
        self.entries
            .iter()
            .any(|entry| entry.index == index && entry.data_type.0 != 0)
    }
}
