//! What a device is asked for, and in which order.

use std::collections::VecDeque;
use std::ops::RangeInclusive;

use lexican_eds::{
    dump::{Answer, Dump},
    ir::{Address, Dictionary},
};

use super::scan::Scan;

/// What to ask for.
#[derive(Clone, Debug)]
pub struct Order {
    /// How many steps there are: values, or indices of a scan.
    total: usize,
    kind: Kind,
}

#[derive(Clone, Debug)]
enum Kind {
    Listed(VecDeque<Address>),
    Scan(Scan),
}

impl Order {
    /// Every value of `dictionary`, but for those whose ObjFlags say that a scan shall not read them (CiA 306-1, 4.6.3.2).
    ///
    /// Those that a client may only write are asked for as well: that the device refuses is worth knowing, and asking changes
    /// nothing.
    #[must_use]
    pub fn every_value(dictionary: &Dictionary) -> Self {
        let read = dictionary.entries().filter(|entry| !entry.refuse_read_on_scan);
        Self::listed(read.map(|entry| entry.address))
    }

    /// These values.
    #[must_use]
    pub fn listed(addresses: impl IntoIterator<Item = Address>) -> Self {
        let addresses: VecDeque<Address> = addresses.into_iter().collect();
        Self {
            total: addresses.len(),
            kind: Kind::Listed(addresses),
        }
    }

    /// Whatever answers in `indices`, of which CiA 301 gives a device 1000h to 9FFFh ([`Order::ALL`]): sub-index 0 of each
    /// index, and the others of those that have them.
    ///
    /// Of an index that is not there nothing is kept. Nearly every index is not there, so a scan takes the time of as many
    /// answers as there are indices: 36,864 are 37 seconds at one millisecond each, and four times as many frames as a
    /// device of 500 values is read with.
    #[must_use]
    pub fn scan(indices: RangeInclusive<u16>) -> Self {
        Self {
            total: indices.len(),
            kind: Kind::Scan(Scan::new(indices)),
        }
    }

    /// 1000h to 9FFFh: communication, manufacturer and device profile area (CiA 301, table 1).
    pub const ALL: RangeInclusive<u16> = 0x1000..=0x9FFF;

    /// What is left when `dump` is there already: what it does not hold, and what timed out. A scan goes on at the last index.
    #[must_use]
    pub fn after(mut self, dump: &Dump) -> Self {
        match &mut self.kind {
            Kind::Listed(addresses) => {
                addresses.retain(|address| matches!(dump.answer(*address), None | Some(Answer::Timeout)));
            }
            Kind::Scan(scan) => {
                if let Some((last, _)) = dump.objects.last_key_value() {
                    scan.skip_to(last.index);
                }
            }
        }
        self
    }

    /// How many steps there are in all: values, or indices of a scan.
    #[must_use]
    pub const fn total(&self) -> usize {
        self.total
    }

    /// How many of them are done.
    #[must_use]
    pub fn done(&self) -> usize {
        let left = match &self.kind {
            Kind::Listed(addresses) => addresses.len(),
            Kind::Scan(scan) => scan.left(),
        };
        self.total.saturating_sub(left)
    }

    /// What to ask for now; the same until [`Order::answered`]; `None` at the end.
    pub(super) fn present(&self) -> Option<Address> {
        match &self.kind {
            Kind::Listed(addresses) => addresses.front().copied(),
            Kind::Scan(scan) => scan.present(),
        }
    }

    /// Goes on behind `answer`. Whether that is worth keeping.
    pub(super) fn answered(&mut self, answer: &Answer) -> bool {
        match &mut self.kind {
            Kind::Listed(addresses) => addresses.pop_front().is_some(),
            Kind::Scan(scan) => scan.answered(answer),
        }
    }
}
