//! 5000h: which errors the CAN bus has, the most frequent first.

/// A kind of error that a CAN controller tells of (ISO 11898-1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BusError {
    /// Nobody has acknowledged a frame.
    Acknowledge,
    /// A field of a fixed form had another one.
    Form,
    /// The check value was wrong.
    Crc,
    /// Six equal bits in a row.
    Stuff,
}

/// How often each kind has occurred since power-on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BusErrors([u16; 4]);

impl BusErrors {
    /// Counts an error.
    pub fn count(&mut self, error: BusError) {
        let [acknowledge, form, crc, stuff] = &mut self.0;
        let counter = match error {
            BusError::Acknowledge => acknowledge,
            BusError::Form => form,
            BusError::Crc => crc,
            BusError::Stuff => stuff,
        };
        *counter = counter.saturating_add(1);
    }

    /// 5000h: a byte for each kind, acknowledge errors in the lowest, then form, CRC and stuff errors: 4 for the most
    /// frequent one, down to 1, and 0 for one that has not occurred. Of those that are equally frequent the one in the lower
    /// byte counts as more frequent.
    #[must_use]
    pub fn ranking(&self) -> u32 {
        let mut ranks = [0; 4];
        for ((nth, count), rank) in self.0.iter().enumerate().zip(&mut ranks) {
            let others = self.0.iter().enumerate();
            let ahead = others.filter(|(other, more)| *more > count || *more == count && *other < nth);
            if *count != 0 {
                *rank = 4 - ahead.fold(0, |ahead, _| ahead + 1);
            }
        }
        u32::from_le_bytes(ranks)
    }
}

#[cfg(test)]
mod tests {
    use super::{BusError, BusErrors};

    #[test]
    fn the_most_frequent_error_ranks_4_and_one_that_has_not_occurred_0() {
        let mut errors = BusErrors::default();
        assert_eq!(errors.ranking(), 0);
        errors.count(BusError::Crc);
        assert_eq!(errors.ranking(), 0x0004_0000);
        for error in [BusError::Stuff, BusError::Stuff, BusError::Acknowledge] {
            errors.count(error);
        }
        assert_eq!(errors.ranking(), 0x0402_0003);
        errors.count(BusError::Form);
        assert_eq!(errors.ranking(), 0x0401_0203);
    }
}
