//! `lexican simulate`: EDS and DCF files as devices on a bus.

mod bus;
mod nodes;
mod record;
mod script;

use std::path::PathBuf;

use clap::Args;

use crate::{Verdict, failure::Failure};

/// Serve EDS or DCF files as devices on a bus
///
/// Each device answers SDO, NMT, LSS, SYNC and PDOs with the code of the firmware, and has the file's defaults, limits and access
/// types. It has no application: a value changes when a client, an RPDO or the script writes it. Ends with Ctrl-C, when the
/// script says so, or when the bus is gone.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Simulate {
    /// The EDS or DCF files
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,

    /// The bus: slcan:/dev/ttyACM0@500k, slcan+tcp://host:port, slcan+tcp-listen://host:port (port 0: any that is free),
    /// socketcan:can0
    #[arg(long, value_name = "BUS")]
    bus: String,

    /// The node-IDs, such as 5 or 1,3,10..20: one for each file, or any number of them for one file. Without it, what a DCF
    /// says, else the lowest that are free
    #[arg(long, value_name = "IDS")]
    node: Option<nodes::Ids>,

    /// Give an object another value at the start, written as in an EDS file; 5/6004:0=1 for node 5 alone
    #[arg(long, value_name = "INDEX:SUB=VALUE")]
    set: Vec<String>,

    /// Write all frames of the bus to this file, as candump -l does
    #[arg(long, value_name = "LOG")]
    record: Option<PathBuf>,

    /// Do what this file says, line by line; `-` is standard input, whose end ends the simulation
    #[arg(long, value_name = "SCRIPT")]
    script: Option<PathBuf>,
}

const EXAMPLES: &str = "\
A script has a command a line:
  6004:0 = 1234        give the object this value, and send the event-driven PDOs that carry it
  5/6004:0 = 0x4D2     the same in node 5 alone; without a node-ID it is meant for all nodes that have the object
  wait 500             wait so many milliseconds
  quit                 end the simulation
  # a comment

Examples:
  lexican simulate pump.eds --bus slcan+tcp-listen://localhost:4711 --node 5
  lexican simulate pump.eds --bus slcan+tcp://localhost:4711 --node 1..127 --record bus.log
  lexican simulate pump.eds valve.dcf --bus slcan:/dev/ttyACM0@500k --node 5,6 --set 5/6004:0=1234
  echo '6004:0 = 99' | lexican simulate pump.eds --bus slcan+tcp://localhost:4711 --script -";

impl Simulate {
    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        let mut nodes = nodes::Nodes::read(&self.files, self.node.as_ref())?;
        nodes.set(&self.set)?;
        let script = script::Script::open(self.script.as_deref(), &nodes)?;
        let record = self.record.as_deref().map(record::Record::create).transpose()?;
        bus::serve(&self.bus, nodes, script, record)?;
        Ok(Verdict::Clean)
    }
}
