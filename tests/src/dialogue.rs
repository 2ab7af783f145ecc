//! Dialogues in text files: what goes in, what comes out.
//!
//! ```text
//! # 6.2.1 Reading the position                 a comment, with the source
//! ! 6004:00 = 44 33 22 11                      the application sets a value, little-endian
//! > 601#4004600000000000                       to the node
//! < 581#4304600044332211                       from the node; "581#43.." is any frame that begins so
//! + 1000                                       ms pass
//!                                              a blank line ends the block
//! @later: PDO                                  the next block needs what is not built yet
//! > 080#
//! < 181#44332211
//! ```
//!
//! Each block is a dialogue with a node that has just booted, in PRE-OPERATIONAL. The node sends nothing that the block
//! does not say: silence needs no line. Its node-ID is that of the first frame in the block that carries one.

use lexican_runtime::{Address, Device};

use crate::{
    bus::{Bus, Slave},
    line,
};

/// A block of a dialogue file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Dialogue {
    /// The line that it starts in, counted from 1.
    pub line: usize,
    /// The comments before and in it.
    pub comments: Vec<String>,
    /// Why it cannot be held yet, if so.
    pub later: Option<String>,
    steps: Vec<Step>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Step {
    Set(Address, Vec<u8>),
    Send(String),
    Expect(String),
    Advance(u64),
}

/// How a file of dialogues went.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Summary {
    /// Blocks held.
    pub held: usize,
    /// Blocks that need what is not built yet.
    pub later: usize,
}

/// Holds all the dialogues of `text`, each with a bus of its own: `booted` makes one with a node of that node-ID on it.
///
/// # Panics
/// When the node says something else, or the text is not made of dialogues; the message names the block by its line.
#[expect(clippy::print_stdout, reason = "a failing test shows which dialogue it was in")]
pub fn hold<D: Device, S: Slave<D>>(text: &str, mut booted: impl FnMut(u8) -> Bus<D, S>) -> Summary {
    let mut summary = Summary::default();
    for dialogue in read(text) {
        if let Some(reason) = &dialogue.later {
            println!("line {}: later: {reason}", dialogue.line);
            summary.later += 1;
        } else {
            println!("line {}: {}", dialogue.line, dialogue.comments.join(" "));
            dialogue.hold(&mut booted(dialogue.node_id()));
            summary.held += 1;
        }
    }
    summary
}

/// The dialogues of `text`.
///
/// # Panics
/// When a line is none of the kinds above.
#[must_use]
pub fn read(text: &str) -> Vec<Dialogue> {
    let mut dialogues = vec![Dialogue::default()];
    for (number, line) in text.lines().enumerate() {
        if line.trim().is_empty() {
            dialogues.push(Dialogue::default());
        } else if let Some(dialogue) = dialogues.last_mut() {
            dialogue.read_line(number + 1, line.trim());
        }
    }
    dialogues.retain(|dialogue| !dialogue.steps.is_empty());
    dialogues
}

impl Dialogue {
    fn read_line(&mut self, number: usize, line: &str) {
        if self.line == 0 {
            self.line = number;
        }
        let (kind, rest) = line.split_at(1);
        let rest = rest.trim();
        match kind {
            "#" => self.comments.push(rest.to_owned()),
            "@" => self.later = Some(rest.trim_start_matches("later:").trim().to_owned()),
            "!" => self.steps.push(set(number, rest)),
            ">" => self.steps.push(Step::Send(rest.to_owned())),
            "<" => self.steps.push(Step::Expect(rest.to_owned())),
            "+" => self.steps.push(Step::Advance(
                rest.parse().unwrap_or_else(|_| panic!("line {number}: + MS")),
            )),
            _ => panic!("line {number}: `{line}` begins with none of # @ ! > < +"),
        }
    }

    /// The node-ID in the first CAN-ID that has one; 1 where none has.
    fn node_id(&self) -> u8 {
        let id = |step: &Step| match step {
            Step::Send(frame) | Step::Expect(frame) => Some(line::frame(frame.trim_end_matches("..")).id()),
            Step::Set(..) | Step::Advance(_) => None,
        };
        let mut ids = self.steps.iter().filter_map(id).filter(|id| !id.is_extended());
        let id = ids.find(|id| matches!(id.number(), 0x181..=0x77F) && id.number() & 0x7F != 0);
        id.map_or(1, |id| id.number().to_le_bytes()[0] & 0x7F)
    }

    /// Holds the dialogue on `bus`.
    fn hold<D: Device, S: Slave<D>>(&self, bus: &mut Bus<D, S>) {
        for step in &self.steps {
            match step {
                Step::Set(address, data) => {
                    let set = bus.slave().set(*address, data);
                    set.unwrap_or_else(|code| panic!("! {address}: {code:?}"));
                }
                Step::Send(frame) => _ = bus.silence().send(frame),
                Step::Expect(frame) => _ = bus.expect(frame),
                Step::Advance(millis) => _ = bus.silence().advance(*millis),
            }
        }
        bus.silence();
    }
}

/// `6004:00 = 44 33 22 11`
fn set(number: usize, text: &str) -> Step {
    let parts = || {
        let (address, data) = text.split_once('=')?;
        let (index, sub) = address.trim().split_once(':')?;
        let index = u16::from_str_radix(index, 16).ok()?;
        let sub = u8::from_str_radix(sub, 16).ok()?;
        Some(Step::Set(Address::new(index, sub), line::bytes(data)))
    };
    parts().unwrap_or_else(|| panic!("line {number}: `{text}` is not INDEX:SUB = BYTES"))
}
