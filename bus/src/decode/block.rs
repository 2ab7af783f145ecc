//! One block of a block transfer, overheard.

use lexican_runtime::wire::sdo::BlockSegment;

/// The segments since the last acknowledgement.
#[derive(Clone, Debug)]
pub(super) struct Block {
    /// Seven bytes a segment, by sequence number.
    bytes: Vec<u8>,
    /// Bit n is set when segment n + 1 was heard.
    heard: u128,
    /// The sequence number of the segment that said it is the last.
    last: Option<u8>,
}

impl Block {
    pub(super) const EMPTY: Self = Self {
        bytes: Vec::new(),
        heard: 0,
        last: None,
    };

    /// Takes a segment; one with the number 0 is none.
    pub(super) fn take(&mut self, segment: BlockSegment) {
        let Some(place) = segment.sequence.checked_sub(1) else {
            return;
        };
        let start = usize::from(place) * 7;
        if self.bytes.len() < start + 7 {
            self.bytes.resize(start + 7, 0);
        }
        if let Some(room) = self.bytes.get_mut(start..start + 7) {
            room.copy_from_slice(&segment.data);
        }
        self.heard |= 1 << place;
        if segment.last {
            self.last = Some(segment.sequence);
        }
    }

    /// Whether segments 1 to `sequence` were all heard.
    pub(super) const fn has(&self, sequence: u8) -> bool {
        sequence <= 127 && self.heard.trailing_ones() >= sequence as u32
    }

    pub(super) fn is_last(&self, sequence: u8) -> bool {
        self.last == Some(sequence)
    }

    /// The bytes of segments 1 to `sequence`, as far as they were heard.
    pub(super) fn first(&self, sequence: u8) -> &[u8] {
        self.bytes.get(..usize::from(sequence) * 7).unwrap_or(&self.bytes)
    }

    pub(super) fn clear(&mut self) {
        self.bytes.clear();
        self.heard = 0;
        self.last = None;
    }
}
