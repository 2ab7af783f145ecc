//! What the user has the devices do: one command a line.

use std::{
    fs,
    io::{self, BufRead as _},
    path::Path,
    str::FromStr,
    sync::mpsc::{Receiver, TryRecvError, sync_channel},
    thread,
    time::{Duration, Instant},
};

use lexican_eds::{ir, literal};
use lexican_runtime::{Address, NodeId};

use super::nodes::{Nodes, node_id};
use crate::failure::{self, Failure};

/// A command.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Command {
    Nothing,
    Assign(Assignment),
    Wait(Duration),
    Quit,
}

/// `[NODE/]INDEX[:SUB] = VALUE`
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Assignment {
    /// `None`: each node that has the object.
    pub(super) node_id: Option<NodeId>,
    pub(super) address: Address,
    value: String,
}

impl FromStr for Command {
    type Err = String;

    fn from_str(line: &str) -> Result<Self, String> {
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            return Ok(Self::Nothing);
        }
        if line == "quit" {
            return Ok(Self::Quit);
        }
        match line.strip_prefix("wait ") {
            Some(time) => wait(time.trim()),
            None => line.parse().map(Self::Assign),
        }
    }
}

fn wait(time: &str) -> Result<Command, String> {
    let millis = time
        .parse()
        .map_err(|_| format!("`{time}` is no number of milliseconds"))?;
    Ok(Command::Wait(Duration::from_millis(millis)))
}

impl FromStr for Assignment {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let unknown =
            || format!("`{text}` is no command; there are `6004:0 = 1234`, `5/6004:0 = 1234`, `wait 500` and `quit`");
        let (object, value) = text.split_once('=').ok_or_else(unknown)?;
        let (id, object) = match object.split_once('/') {
            Some((id, object)) => (Some(node_id(id)?), object),
            None => (None, object),
        };
        Ok(Self {
            node_id: id,
            address: address(object.trim()).ok_or_else(unknown)?,
            value: value.trim().to_owned(),
        })
    }
}

/// `6004:0`, `1018:1`, `1017`: hexadecimal, as everywhere on the command line.
fn address(text: &str) -> Option<Address> {
    let (index, sub) = text.split_once(':').unwrap_or((text, "0"));
    let index = index.trim().trim_end_matches(['h', 'H']);
    let index = index.strip_prefix("0x").unwrap_or(index);
    let sub = sub.trim().trim_end_matches(['h', 'H']);
    let sub = sub.strip_prefix("0x").unwrap_or(sub);
    Some(Address::new(
        u16::from_str_radix(index, 16).ok()?,
        u8::from_str_radix(sub, 16).ok()?,
    ))
}

impl Assignment {
    /// The value as it is on the bus.
    pub(super) fn bytes(&self, data_type: ir::DataType, node_id: NodeId) -> Result<Vec<u8>, String> {
        let value = literal::value(&self.value, data_type).map_err(|_| {
            format!(
                "`{}` is no value of {}, the data type of {}",
                self.value,
                data_type.name(),
                self.object()
            )
        })?;
        Ok(value.value.to_bytes(data_type, ir::NodeId::new(node_id.get())))
    }

    /// The object, as messages call it.
    pub(super) fn object(&self) -> String {
        format!("{:04X}h:{:02X}", self.address.index, self.address.sub)
    }
}

/// The lines of a script as they come.
pub(super) struct Script {
    name: String,
    lines: Option<Receiver<String>>,
    number: usize,
    waits_until: Option<Instant>,
    /// Whether the simulation ends with it.
    is_leading: bool,
}

/// What is to be done now.
#[derive(Debug, PartialEq)]
pub(super) enum Next {
    Nothing,
    Assign(Assignment),
    Quit,
}

impl Script {
    /// A file is read, and held against the nodes, before anything starts; standard input is heeded line by line.
    pub(super) fn open(path: Option<&Path>, nodes: &Nodes) -> Result<Self, Failure> {
        let mut script = Self {
            name: path.map_or_else(String::new, |path| path.display().to_string()),
            lines: None,
            number: 0,
            waits_until: None,
            is_leading: path == Some(Path::new("-")),
        };
        if script.is_leading {
            script.name = "<stdin>".into();
            script.lines = Some(read_stdin()?);
        } else if let Some(path) = path {
            let text = fs::read_to_string(path).map_err(|error| Failure::io("cannot read", &script.name, &error))?;
            check(&script.name, &text, nodes)?;
            let (sender, lines) = sync_channel(text.lines().count() + 1);
            for line in text.lines() {
                let _ = sender.try_send(line.to_owned());
            }
            script.lines = Some(lines);
        }
        Ok(script)
    }

    /// The next command that is due; one that cannot be understood is told of and passed over.
    pub(super) fn next(&mut self, now: Instant) -> Next {
        while self.waits_until.is_none_or(|end| now >= end) {
            let Some(line) = self.lines.as_ref().map(Receiver::try_recv) else {
                return Next::Nothing;
            };
            match line {
                Err(TryRecvError::Empty) => return Next::Nothing,
                Err(TryRecvError::Disconnected) => {
                    self.lines = None;
                    return if self.is_leading { Next::Quit } else { Next::Nothing };
                }
                Ok(line) => match self.heed(&line, now) {
                    Next::Nothing => {}
                    next => return next,
                },
            }
        }
        Next::Nothing
    }

    fn heed(&mut self, line: &str, now: Instant) -> Next {
        self.number += 1;
        match line.parse() {
            Ok(Command::Assign(assignment)) => return Next::Assign(assignment),
            Ok(Command::Quit) => return Next::Quit,
            Ok(Command::Wait(time)) => self.waits_until = now.checked_add(time),
            Ok(Command::Nothing) => {}
            Err(reason) => self.complain(&reason),
        }
        Next::Nothing
    }

    /// Tells that the last line could not be carried out.
    pub(super) fn complain(&self, reason: &str) {
        failure::note(&format!("{}:{}: {reason}", self.name, self.number));
    }

    /// For how long nothing is to be done, as far as that is known: not longer than one may wait for a line that is typed.
    pub(super) fn patience(&self, now: Instant) -> Option<Duration> {
        self.lines.as_ref()?;
        Some(match self.waits_until {
            Some(end) if end > now => end - now,
            _ => Duration::from_millis(5),
        })
    }
}

/// All lines can be understood, and all objects are there.
fn check(name: &str, text: &str, nodes: &Nodes) -> Result<(), Failure> {
    for (number, line) in (1..).zip(text.lines()) {
        let checked = line.parse().and_then(|command| match command {
            Command::Assign(assignment) => nodes.values(&assignment).map(drop),
            _ => Ok(()),
        });
        checked.map_err(|reason| Failure::new(format!("{name}:{number}: {reason}")))?;
    }
    Ok(())
}

/// A thread that reads: it ends with the input, or with the process.
fn read_stdin() -> Result<Receiver<String>, Failure> {
    let (sender, lines) = sync_channel(1024);
    let reader = thread::Builder::new().name("script".into()).spawn(move || {
        for line in io::stdin().lock().lines().map_while(Result::ok) {
            if sender.send(line).is_err() {
                return;
            }
        }
    });
    reader.map_err(|error| Failure::io("cannot read", "standard input", &error))?;
    Ok(lines)
}
