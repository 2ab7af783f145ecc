//! What a state makes of an answer.

use lexican_runtime::{
    AbortCode,
    wire::sdo::{Expedited, Request},
};

/// What is to be done next.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// The answer was none to what was asked: wait on.
    PassOver,
    /// The answer counts, and there is more to come: wait anew.
    Wait,
    /// Send these and wait anew.
    Send(Vec<[u8; 8]>),
    /// The value would be had sooner in blocks: give this transfer up and open another.
    ToBlocks,
    /// The transfer is over; of an upload with the value.
    Done(Vec<u8>),
    /// The transfer is over as soon as this has been sent.
    Last([u8; 8], Vec<u8>),
    /// The server refuses.
    Refused(AbortCode),
    /// The server breaks the protocol: tell it so.
    Broken(AbortCode),
}

impl Step {
    /// Send this and wait anew.
    pub(super) fn send(request: Request) -> Self {
        Self::Send(vec![request.emit()])
    }
}

/// The bytes that count; all four when the sender did not say how many.
pub(super) fn expedited(value: Expedited) -> Vec<u8> {
    let length = usize::from(value.length.unwrap_or(4)).min(4);
    value.bits.to_le_bytes().into_iter().take(length).collect()
}

/// A value never gets longer than this many bytes, so that a server that never ends fills no memory.
pub(super) const LONGEST: usize = 64 << 20;

/// Whether `length` bytes, of which `announced` are to come, are too many.
pub(super) fn is_too_long(length: usize, announced: Option<u32>) -> bool {
    length > announced.map_or(LONGEST, |size| usize::try_from(size).unwrap_or(LONGEST).min(LONGEST))
}

/// Whether `length` bytes are all that were announced.
pub(super) fn is_whole(length: usize, announced: Option<u32>) -> bool {
    announced.is_none_or(|size| u32::try_from(length) == Ok(size))
}
