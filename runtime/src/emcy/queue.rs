//! Messages that wait to be sent, the oldest first.

/// How many there may be.
pub(super) const CAPACITY: usize = 8;

/// A ring of messages.
#[derive(Clone, Debug)]
pub(super) struct Queue {
    messages: [[u8; 8]; CAPACITY],
    /// Where the oldest one stands.
    first: usize,
    length: usize,
}

impl Queue {
    pub(super) const fn new() -> Self {
        Self {
            messages: [[0; 8]; CAPACITY],
            first: 0,
            length: 0,
        }
    }

    pub(super) const fn is_empty(&self) -> bool {
        self.length == 0
    }

    /// Adds a message; drops the oldest one when there is no room.
    pub(super) fn push(&mut self, message: [u8; 8]) {
        if self.length == CAPACITY {
            self.pop();
        }
        let at = (self.first + self.length) % CAPACITY;
        if let Some(place) = self.messages.get_mut(at) {
            *place = message;
            self.length += 1;
        }
    }

    /// Takes the oldest message.
    pub(super) fn pop(&mut self) -> Option<[u8; 8]> {
        if self.is_empty() {
            return None;
        }
        let message = self.messages.get(self.first).copied();
        self.first = (self.first + 1) % CAPACITY;
        self.length -= 1;
        message
    }
}

#[cfg(test)]
mod tests {
    use super::{Queue, CAPACITY};

    #[test]
    fn the_oldest_are_dropped_when_there_is_no_room() {
        let mut queue = Queue::new();
        for number in 0..=9 {
            queue.push([number; 8]);
        }
        let rest: [_; CAPACITY] = core::array::from_fn(|_| queue.pop().unwrap()[0]);
        assert_eq!(rest, [2, 3, 4, 5, 6, 7, 8, 9]);
        assert_eq!(queue.pop(), None);
    }
}
