//! `lexican dump`: what a device answers for each of its objects.

use std::{path::PathBuf, time::SystemTime};

use clap::Args;
use lexican_bus::dump::Order;
use lexican_eds::{dump::Dump, ir::NodeId};

use super::{
    live::{End, Live, LiveArguments, Taken, node_id},
    recorded::parse_dump,
    validate::read_eds,
};
use crate::{
    Verdict,
    failure::{self, Failure},
    input::Input,
    output,
};

/// Read the objects of a device on a bus into a file
///
/// Asks for every value that the EDS file describes, or, without one, for whatever there is from 1000h to 9FFFh. What the device
/// refuses or does not answer is recorded with the rest. Ctrl-C keeps what was read, and --resume goes on. Ends with 2 when not
/// all could be read.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct DumpDevice {
    /// The bus: slcan+tcp://HOST:PORT, slcan:DEVICE, socketcan:INTERFACE …
    #[arg(long)]
    bus: String,

    /// The devices: one node-ID, or several with commas
    #[arg(long, value_name = "N", value_delimiter = ',', required_unless_present = "resume", value_parser = node_id)]
    node: Vec<NodeId>,

    /// The EDS or DCF file of the device
    #[arg(long, value_name = "FILE")]
    eds: Option<PathBuf>,

    /// Write to this file instead of to standard output; of several devices `{node}` in it is the node-ID
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,

    /// Go on with this dump, which ended before its time
    #[arg(long, value_name = "DUMP")]
    resume: Option<PathBuf>,

    #[command(flatten)]
    live: LiveArguments,
}

const EXAMPLES: &str = "\
Examples:
  lexican dump --bus slcan+tcp://localhost:4711 --node 5 --eds pump.eds -o node5.json
  lexican dump --bus socketcan:can0 --node 5,6,7 -o node{node}.json
  lexican dump --bus socketcan:can0 --resume node5.json -o node5.json";

/// What stands for the node-ID in the name of a file.
const PLACE: &str = "{node}";

impl DumpDevice {
    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        let begun = self.begun()?;
        self.check_output(begun.len())?;
        let order = self.order()?;
        let mut live = self.live.open(&self.bus)?;
        let mut verdict = Verdict::Clean;
        for dump in begun {
            let taken = live.take(dump, order.clone(), true);
            if !self.keep(taken)? {
                verdict = Verdict::Incomplete;
            }
            if live.is_stopped() {
                break;
            }
        }
        Ok(verdict)
    }

    /// The dumps to go on with.
    fn begun(&self) -> Result<Vec<Dump>, Failure> {
        let Some(path) = &self.resume else {
            return Ok(self.node.iter().copied().map(Dump::new).collect());
        };
        let input = Input::new(path);
        let dump = parse_dump(&input, &input.read()?)?;
        let (path, node) = (path.display(), dump.node_id.get());
        if self.node.iter().any(|wanted| *wanted != dump.node_id) {
            return Err(Failure::new(format!(
                "{path} is of node {node}; leave --node out to go on with it"
            )));
        }
        Ok(vec![dump])
    }

    /// Two devices do not go into one file.
    fn check_output(&self, devices: usize) -> Result<(), Failure> {
        let output = self.output.as_deref().map(|path| path.display().to_string());
        if devices < 2 || output.is_some_and(|name| name.contains(PLACE)) {
            return Ok(());
        }
        Err(Failure::new(
            "a dump is of one device; name a file for each, as -o node{node}.json",
        ))
    }

    fn order(&self) -> Result<Order, Failure> {
        let Some(path) = &self.eds else {
            return Ok(Order::scan(Order::ALL));
        };
        Ok(Order::every_value(&read_eds(path)?.dictionary))
    }

    /// Writes what was read, if anything; whether that is all.
    fn keep(&self, taken: Taken) -> Result<bool, Failure> {
        let Taken { mut dump, end } = taken;
        if !dump.objects.is_empty() {
            dump.taken = Some(humantime::format_rfc3339_seconds(SystemTime::now()).to_string());
            output::write(&self.place(dump.node_id), &dump.to_json())?;
        }
        match end {
            End::Whole => return Ok(true),
            End::Stopped(done, total) => failure::note(&format!(
                "stopped after {done} of {total}; --resume with this dump goes on"
            )),
            End::Failed(error) if dump.objects.is_empty() => Failure::new(error.to_string()).print(),
            End::Failed(error) => Failure::new(format!("{error}; what was read is kept, --resume goes on")).print(),
        }
        Ok(false)
    }

    fn place(&self, node_id: NodeId) -> PathBuf {
        let Some(path) = &self.output else {
            return PathBuf::from("-");
        };
        let name = path.to_string_lossy();
        name.replace(PLACE, &node_id.get().to_string()).into()
    }
}

/// What is read of `node_id` for a validation; fails when that is nothing, and tells when it is not all.
pub(super) fn take_for_validation(
    live: &mut Live,
    node_id: NodeId,
    order: Order,
    shown: bool,
) -> Result<Dump, Failure> {
    let Taken { dump, end } = live.take(Dump::new(node_id), order, shown);
    match end {
        End::Whole => Ok(dump),
        End::Stopped(..) => Err(Failure::new("stopped; nothing was validated")),
        End::Failed(error) => Err(Failure::new(error.to_string())),
    }
}
