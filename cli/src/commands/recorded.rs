//! What `lexican validate` holds against a file: a dump, or a log in which the device was read.

use std::{
    io::{BufRead as _, ErrorKind},
    path::Path,
};

use lexican_bus::{
    decode::{Decoder, Description, Direction, Overheard, Survey},
    log::Reader,
};
use lexican_eds::{Reading, dump::Dump};
use lexican_runtime::NodeId;

use super::decode::{Text, mention_damage, open, unreadable};
use crate::{
    failure::{self, Failure},
    input::Input,
};

/// What a device answered, and where that was written down.
pub(crate) struct Recorded {
    pub(crate) dump: Dump,
    /// A log has what somebody happened to ask for, a dump everything.
    pub(crate) is_log: bool,
}

impl Recorded {
    /// Reads `path`: a dump begins with `{`, all else is a log. Of a log `node` is taken, else the only one that was read.
    pub(crate) fn read(path: &Path, node: Option<NodeId>, reading: &Reading) -> Result<Self, Failure> {
        let input = Input::new(path);
        let mut text = open(&input)?;
        let head = text
            .fill_buf()
            .map_err(|error| Failure::io("cannot read", &input.name(), &error))?;
        if head
            .trim_ascii_start()
            .strip_prefix(b"\xEF\xBB\xBF")
            .unwrap_or(head)
            .trim_ascii_start()
            .starts_with(b"{")
        {
            return read_dump(&input, text, node);
        }
        // What is no log is refused in the words for a dump.
        let head = head.to_owned();
        read_log(&input, text, &head, node, reading)
    }
}

fn read_dump(input: &Input, mut text: Text, node: Option<NodeId>) -> Result<Recorded, Failure> {
    let mut bytes = Vec::new();
    std::io::Read::read_to_end(&mut text, &mut bytes)
        .map_err(|error| Failure::io("cannot read", &input.name(), &error))?;
    let dump = parse_dump(input, &bytes)?;
    match node {
        Some(node) if node.get() != dump.node_id.get() => Err(Failure::new(format!(
            "{} is a dump of node {}, not of node {}; leave out --node, which is for logs",
            input.name(),
            dump.node_id.get(),
            node.get()
        ))),
        _ => Ok(Recorded { dump, is_log: false }),
    }
}

pub(super) fn parse_dump(input: &Input, bytes: &[u8]) -> Result<Dump, Failure> {
    Dump::from_json(bytes).map_err(|error| Failure::new(format!("{}:{error}; {}", input.name(), error.help())))
}

fn read_log(
    input: &Input,
    text: Text,
    head: &[u8],
    node: Option<NodeId>,
    reading: &Reading,
) -> Result<Recorded, Failure> {
    let description = Description::new(&reading.dictionary);
    let mut reader = Reader::new(text);
    let surveys = match overhear(&mut reader, &description) {
        Err(error) if error.kind() == ErrorKind::InvalidData => return Err(not_a_recording(input, head)),
        Err(error) => return Err(unreadable(input, &error)),
        Ok(surveys) if reader.format().is_none() && surveys.is_empty() => return Err(not_a_recording(input, head)),
        Ok(surveys) => surveys,
    };
    mention_damage(input, reader.summary());
    let overheard = choose(input, &surveys, node)?;
    mention(input, overheard);
    Ok(Recorded {
        dump: overheard.dump.clone(),
        is_log: true,
    })
}

fn not_a_recording(input: &Input, head: &[u8]) -> Failure {
    match parse_dump(input, head) {
        Err(failure) => failure,
        Ok(_) => Failure::new(format!("{} is neither a dump nor a log", input.name())),
    }
}

/// Every bus of the log for itself.
fn overhear(reader: &mut Reader<Text>, description: &Description) -> std::io::Result<Vec<Survey>> {
    let mut buses: Vec<(Decoder<'_>, Survey)> = Vec::new();
    while let Some(record) = reader.next_record()? {
        let number = record.channel.number();
        if buses.len() <= number {
            buses.resize_with(number + 1, || (Decoder::new(Some(description)), Survey::default()));
        }
        if let Some((decoder, survey)) = buses.get_mut(number) {
            survey.hear(record.time, &decoder.decode(&record.frame));
        }
    }
    Ok(buses.into_iter().map(|(_, survey)| survey).collect())
}

/// The node that is meant, or the only one that was read.
fn choose<'a>(input: &Input, surveys: &'a [Survey], node: Option<NodeId>) -> Result<&'a Overheard, Failure> {
    let all = surveys.iter().flat_map(Survey::nodes);
    let read = all.filter(|(_, overheard)| !overheard.dump.objects.is_empty());
    let found: Vec<_> = read
        .filter(|(node_id, _)| node.is_none_or(|node| node == *node_id))
        .collect();
    let name = input.name();
    match (found.as_slice(), node) {
        ([(_, overheard)], _) => Ok(overheard),
        ([], Some(node)) => Err(Failure::new(format!(
            "in {name} nobody reads an object of node {}",
            node.get()
        ))),
        ([], None) => Err(Failure::new(format!("in {name} nobody reads an object of any node"))),
        (several, None) => {
            let numbers: Vec<String> = several.iter().map(|(node_id, _)| node_id.get().to_string()).collect();
            let numbers = numbers.join(", ");
            Err(Failure::new(format!(
                "in {name} the nodes {numbers} are read; say which one is meant: --node N"
            )))
        }
        (_, Some(node)) => Err(Failure::new(format!(
            "{name} has several buses with a node {}; keep the lines of one",
            node.get()
        ))),
    }
}

/// What a log tells beside values, on stderr.
fn mention(input: &Input, overheard: &Overheard) {
    let (name, node) = (input.name(), overheard.dump.node_id.get());
    let state = overheard
        .state
        .map_or_else(String::new, |state| format!(", the last one {state:?}"));
    failure::note(&format!(
        "{name}: node {node} answers for {} values; {} transfers are not there as a whole; {} boot-ups, {} heartbeats{state}, {} emergencies",
        overheard.dump.objects.len(),
        overheard.incomplete,
        overheard.boot_ups,
        overheard.heartbeats,
        overheard.emergencies,
    ));
    for (time, emergency, meaning) in &overheard.first_emergencies {
        let (seconds, micros) = (time.as_micros() / 1_000_000, time.as_micros() % 1_000_000);
        let (code, register) = (emergency.code, emergency.register);
        failure::note(&format!(
            "{name}: emergency of node {node} at {seconds}.{micros:06}: {code:04X}h {meaning}, register {register:02X}h"
        ));
    }
    for ((direction, number), wrong) in &overheard.wrong_pdos {
        let pdo = match direction {
            Direction::Receive => "RPDO",
            Direction::Transmit => "TPDO",
        };
        failure::note(&format!(
            "{name}: {pdo} {number} of node {node} has {} bytes where {} are mapped, in {} frames",
            wrong.length, wrong.mapped, wrong.frames
        ));
    }
}
