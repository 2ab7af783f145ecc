//! `lexican decode`: a log in the dictionary's words.

use std::{
    fs::File,
    io::{self, BufReader, ErrorKind, Read, Write as _},
    path::PathBuf,
};

use clap::{Args, ValueEnum};
use lexican_bus::{
    decode::{Decoder, write_json, write_text},
    log::{Reader, Record, Summary},
};

use super::nodes::{DescribedNode, Nodes};
use crate::{
    Verdict,
    failure::{self, Failure},
    input::Input,
    output::{Stdout, unwritten},
};

/// How much text is read and written at a time, in bytes.
const CHUNK: usize = 1 << 16;

/// Print a log of a bus in the words of the dictionary
///
/// Reads logs of candump, Vector's ASC and python-can's CSV, of any length, and prints a line a frame: objects with their
/// names, values by their data types, NMT, emergencies, LSS. Damaged lines are passed over and counted on standard error.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Decode {
    /// The log, or `-` for standard input
    log: PathBuf,

    /// The EDS or DCF file of a node; without @NODE that of its DCF, or of all nodes that no other file describes
    #[arg(long = "eds", value_name = "FILE[@NODE]")]
    descriptions: Vec<DescribedNode>,

    /// The form of the lines
    #[arg(long, value_enum, value_name = "FORMAT", default_value_t)]
    format: Form,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum Form {
    /// For people: time, bus, identifier, data, node, service, and what it says
    #[default]
    Text,
    /// For programs: a JSON object a line, as docs/decode-format.md of the repository describes it
    Json,
}

const EXAMPLES: &str = "\
Examples:
  lexican decode candump.log --eds encoder.eds@5 --eds drive.eds@6
  candump can0 | lexican decode - --eds encoder.eds
  lexican decode drive.asc --format json";

impl Decode {
    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        let nodes = Nodes::read(&self.descriptions)?;
        let input = Input::new(&self.log);
        let mut reader = Reader::new(open(&input)?);
        let mut out = Stdout::plain();
        let printed = print(&mut reader, &nodes, self.format, &mut out);
        out.finish()?;
        printed.map_err(|stopped| stopped.into_failure(&input))?;
        mention_damage(&input, reader.summary());
        Ok(Verdict::Clean)
    }
}

/// The text of a log.
pub(crate) type Text = BufReader<Box<dyn Read>>;

/// Opens a log, to be read a part at a time.
pub(crate) fn open(input: &Input) -> Result<Text, Failure> {
    let text: Box<dyn Read> = match input {
        Input::Stdin => Box::new(io::stdin().lock()),
        Input::File(path) => {
            let file = File::open(path).map_err(|error| Failure::io("cannot read", &input.name(), &error))?;
            Box::new(file)
        }
    };
    Ok(BufReader::with_capacity(CHUNK, text))
}

/// Why printing ended before the log.
enum Stopped {
    Read(io::Error),
    Write(io::Error),
}

impl Stopped {
    fn into_failure(self, input: &Input) -> Failure {
        match self {
            Self::Read(error) => unreadable(input, &error),
            Self::Write(error) => unwritten(&error),
        }
    }
}

/// The log cannot be read, or is none.
pub(crate) fn unreadable(input: &Input, error: &io::Error) -> Failure {
    if error.kind() == ErrorKind::InvalidData {
        return Failure::new(format!("{}: {error}; name a log of one of them", input.name()));
    }
    Failure::io("cannot read", &input.name(), error)
}

/// Every bus of the log has nodes of its own. What is printed gets out before more of the log is waited for.
fn print(reader: &mut Reader<Text>, nodes: &Nodes, form: Form, out: &mut Stdout) -> Result<(), Stopped> {
    let mut buses: Vec<Decoder> = Vec::new();
    let mut lines = String::new();
    while let Some(record) = reader.next_record().map_err(Stopped::Read)? {
        let number = record.channel.number();
        if buses.len() <= number {
            buses.resize_with(number + 1, || nodes.decoder());
        }
        if let Some(bus) = buses.get_mut(number) {
            write_line(&mut lines, &record, reader.channel_name(record.channel), bus, form);
        }
        let waits = !reader.has_next_line();
        if waits || lines.len() >= CHUNK {
            out.write_all(lines.as_bytes()).map_err(Stopped::Write)?;
            lines.clear();
        }
        if waits {
            out.flush().map_err(Stopped::Write)?;
        }
    }
    out.write_all(lines.as_bytes()).map_err(Stopped::Write)
}

fn write_line(lines: &mut String, record: &Record, channel: &str, bus: &mut Decoder<'_>, form: Form) {
    let message = bus.decode(&record.frame);
    match form {
        Form::Text => write_text(lines, record, channel, &message),
        Form::Json => write_json(lines, record, channel, &message),
    }
}

/// Tells on stderr which lines could not be read.
pub(crate) fn mention_damage(input: &Input, summary: &Summary) {
    let Some(first) = summary.damages.first() else { return };
    let numbers: Vec<String> = summary.damages.iter().map(|damage| damage.line.to_string()).collect();
    let more = if summary.damaged > numbers.len() as u64 {
        " …"
    } else {
        ""
    };
    failure::note(&format!(
        "{}:{}: {}; {} of {} lines could not be read and were passed over: {}{more}",
        input.name(),
        first.line,
        first.reason,
        summary.damaged,
        summary.lines,
        numbers.join(", "),
    ));
}
