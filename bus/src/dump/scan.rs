//! Finds the objects of a device without its EDS.
//!
//! Sub-index 0 says what an object is, as far as it can be known: a value of another length than one byte is a VAR; one byte
//! may be a VAR, or the highest sub-index of an ARRAY or RECORD. That shows at sub-index 1 and 2: a record may leave one of
//! them out, but one that has neither is taken for a VAR. Behind the highest sub-index one more is tried, as a device may
//! miscount.

use std::ops::RangeInclusive;

use lexican_eds::{dump::Answer, ir::Address};

/// A walk over the indices.
#[derive(Clone, Debug)]
pub(super) struct Scan {
    /// The index, beyond `last` at the end.
    index: u32,
    last: u16,
    state: State,
}

#[derive(Clone, Copy, Debug)]
enum State {
    /// Sub-index 0 is asked for.
    Zero,
    /// `sub` is asked for; 0 said `highest`; whether one behind 0 has answered yet.
    Sub { sub: u8, highest: u8, found: bool },
}

/// How many of the first sub-indices have to be absent for the object to have none.
const FIRST: u8 = 2;

impl Scan {
    pub(super) fn new(indices: RangeInclusive<u16>) -> Self {
        Self {
            index: u32::from(*indices.start()),
            last: *indices.end(),
            state: State::Zero,
        }
    }

    pub(super) fn skip_to(&mut self, index: u16) {
        self.index = self.index.max(u32::from(index));
    }

    /// Indices that are not done.
    pub(super) fn left(&self) -> usize {
        let end = u32::from(self.last) + 1;
        usize::try_from(end.saturating_sub(self.index)).unwrap_or(0)
    }

    pub(super) fn present(&self) -> Option<Address> {
        let index = u16::try_from(self.index).ok().filter(|index| *index <= self.last)?;
        Some(match self.state {
            State::Zero => Address::new(index, 0),
            State::Sub { sub, .. } => Address::new(index, sub),
        })
    }

    /// Goes on behind `answer`. Whether that is worth keeping: an index that is not there is not, nor what was only tried.
    pub(super) fn answered(&mut self, answer: &Answer) -> bool {
        match self.state {
            State::Zero => self.on_zero(answer),
            State::Sub { sub, highest, found } => self.on_sub(sub, highest, found, answer),
        }
    }

    fn on_zero(&mut self, answer: &Answer) -> bool {
        match answer {
            Answer::Value(bytes) => match bytes.as_slice() {
                [highest @ 1..=0xFE] => self.ask(1, *highest, false),
                _ => self.next_index(),
            },
            Answer::Abort(_) | Answer::Timeout => self.next_index(),
        }
        !answer.is_absence()
    }

    fn on_sub(&mut self, sub: u8, highest: u8, found: bool, answer: &Answer) -> bool {
        let found = found || !answer.is_absence();
        let keep = found && (sub <= highest || !answer.is_absence());
        let has_none = !found && sub >= FIRST.min(highest);
        if has_none || sub > highest || sub == 0xFE {
            self.next_index();
        } else {
            self.ask(sub + 1, highest, found);
        }
        keep
    }

    const fn ask(&mut self, sub: u8, highest: u8, found: bool) {
        self.state = State::Sub { sub, highest, found };
    }

    const fn next_index(&mut self) {
        self.index += 1;
        self.state = State::Zero;
    }
}

#[cfg(test)]
mod tests {
    use lexican_eds::dump::AbortCode;

    use super::*;

    /// What is asked of a device that has `objects`, and what is kept.
    fn scan(indices: RangeInclusive<u16>, objects: &[(u16, u8, &[u8])]) -> (Vec<String>, Vec<String>) {
        let mut scan = Scan::new(indices);
        let (mut asked, mut kept) = (Vec::new(), Vec::new());
        while let Some(address) = scan.present() {
            asked.push(address.to_string());
            let found = objects
                .iter()
                .find(|(index, sub, _)| Address::new(*index, *sub) == address);
            let is_object = objects.iter().any(|(index, ..)| *index == address.index);
            let answer = match found {
                Some((.., bytes)) => Answer::Value(bytes.to_vec()),
                None if is_object => Answer::Abort(AbortCode::NO_SUCH_SUB_INDEX),
                None => Answer::Abort(AbortCode::NO_SUCH_OBJECT),
            };
            if scan.answered(&answer) {
                kept.push(address.to_string());
            }
        }
        (asked, kept)
    }

    #[test]
    fn a_value_of_four_bytes_has_no_sub_indices() {
        let (asked, kept) = scan(0x1000..=0x1001, &[(0x1000, 0, &[1, 2, 3, 4])]);
        assert_eq!(asked, ["1000sub0", "1001sub0"]);
        assert_eq!(kept, ["1000sub0"]);
    }

    #[test]
    fn a_record_is_read_with_its_holes_and_one_more_is_tried() {
        let objects: [(u16, u8, &[u8]); 3] = [(0x1018, 0, &[3]), (0x1018, 2, &[7]), (0x1018, 4, &[9])];
        let (asked, kept) = scan(0x1018..=0x1018, &objects);
        assert_eq!(asked, ["1018sub0", "1018sub1", "1018sub2", "1018sub3", "1018sub4"]);
        assert_eq!(kept, ["1018sub0", "1018sub2", "1018sub3", "1018sub4"]);
    }

    #[test]
    fn a_byte_that_counts_nothing_costs_two_questions() {
        let (asked, kept) = scan(0x1001..=0x1001, &[(0x1001, 0, &[200])]);
        assert_eq!(asked, ["1001sub0", "1001sub1", "1001sub2"]);
        assert_eq!(kept, ["1001sub0"]);
    }

    #[test]
    fn the_last_index_of_all_ends_the_scan() {
        let (asked, _) = scan(0xFFFE..=0xFFFF, &[]);
        assert_eq!(asked, ["FFFEsub0", "FFFFsub0"]);
    }
}
