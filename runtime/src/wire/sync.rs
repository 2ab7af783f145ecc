//! SYNC (CiA 301, 7.2.5): from one producer to all, with a counter when 1019h asks for one.
//!
//! ```text
//! 080#        without a counter
//! 080#01      with it: 1 to the overflow value, then 1 again
//! ```

use super::{CanId, Frame};

/// The frame on `id`, with the counter if it has one.
#[must_use]
pub const fn emit(id: CanId, counter: Option<u8>) -> Frame {
    match counter {
        Some(counter) => Frame::byte(id, counter),
        None => Frame::from_word(id, 0, 0),
    }
}

/// The counter in a frame with this identifier, for a network that counts (`counts`) or does not: then it is 0. `None` when
/// the frame has another length than that asks for.
#[inline]
#[must_use]
pub fn parse(frame: &Frame, counts: bool) -> Option<u8> {
    let [counter, ..] = frame.word().to_le_bytes();
    // Without data it is 0.
    (!frame.is_remote() && frame.length() == usize::from(counts)).then_some(counter)
}

#[cfg(test)]
mod tests {
    use super::{emit, parse};
    use crate::wire::CanId;

    #[test]
    fn what_is_emitted_is_parsed_again() {
        let id = CanId::standard(0x80).unwrap();
        assert_eq!(parse(&emit(id, None), false), Some(0));
        assert_eq!(parse(&emit(id, Some(7)), true), Some(7));
        assert_eq!(parse(&emit(id, None), true), None);
        assert_eq!(parse(&emit(id, Some(7)), false), None);
    }
}
