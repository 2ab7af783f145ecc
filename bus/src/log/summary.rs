//! What became of the lines of a log.

/// How many damaged lines are remembered one by one: a log may have a million of them.
const REMEMBERED: usize = 20;

/// The lines of a log, counted.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Summary {
    /// All lines.
    pub lines: u64,
    /// Those with a classic CAN frame.
    pub frames: u64,
    /// Those that are in order and have none: headers, comments, CAN FD, error frames, events of a tool.
    pub passed_over: u64,
    /// Those that are damaged.
    pub damaged: u64,
    /// The first 20 of the damaged lines.
    pub damages: Vec<Damage>,
}

/// A line that could not be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Damage {
    /// The line's number, from 1.
    pub line: u64,
    /// What is wrong with it.
    pub reason: &'static str,
}

impl Summary {
    /// Counts the line that is read as damaged.
    pub(super) fn damage(&mut self, reason: &'static str) {
        self.damaged += 1;
        if self.damages.len() < REMEMBERED {
            self.damages.push(Damage {
                line: self.lines,
                reason,
            });
        }
    }
}
