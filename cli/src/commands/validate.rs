//! `lexican validate`: what a device answered, held against its file.

use std::path::{Path, PathBuf};

use clap::Args;
use lexican_bus::dump::Order;
use lexican_eds::{
    Reading,
    diagnostic::Level,
    document::Problem,
    dump::Dump,
    ir, render,
    rules::{self, LevelChange, Levels},
};
use lexican_runtime::NodeId;

use super::{
    dump::take_for_validation, live::LiveArguments, recorded::Recorded, settings::SettingsArguments,
    shown::ShownArguments,
};
use crate::{
    Verdict,
    config::Settings,
    failure::{self, Failure},
    format::{Printer, Subject},
    input::Input,
};

/// Hold what a device answered against its EDS or DCF file
///
/// Reports each difference at its place in the file, with its rule and the cure. Ends with 0 when nothing is found at level
/// deny, with 1 when something is, with 2 when a file cannot be read.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Validate {
    /// The EDS or DCF file of the device, or `-` for standard input
    eds: PathBuf,

    /// What the device answered, or `-` for standard input: a dump as docs/dump-format.md of the repository describes it, or a
    /// log of candump, Vector's ASC or python-can's CSV in which somebody reads the device
    #[arg(value_name = "DUMP|LOG", required_unless_present = "bus", conflicts_with = "bus")]
    dump: Option<PathBuf>,

    /// Read the device on this bus instead of a dump: slcan+tcp://HOST:PORT, socketcan:INTERFACE …
    #[arg(long, requires = "node")]
    bus: Option<String>,

    #[command(flatten)]
    live: LiveArguments,

    /// The node-ID of the device on the bus or in a log; of a log not needed when no other node is read there
    #[arg(long, value_name = "NODE", value_parser = node_id)]
    node: Option<NodeId>,

    #[command(flatten)]
    shown: ShownArguments,

    #[command(flatten)]
    settings: SettingsArguments,
}

const EXAMPLES: &str = "\
Examples:
  lexican validate pump.eds node5.json
  lexican validate pump.dcf node5.json --level DMP002=allow --level DMP019=deny
  lexican validate --format json pump.eds - < node5.json
  lexican validate pump.eds --bus socketcan:can0 --node 5
  lexican validate pump.eds bus.log --node 5 --format html > report.html";

impl Validate {
    pub(crate) fn run(self) -> Result<Verdict, Failure> {
        let settings = self.settings.of(&Input::new(&self.eds))?;
        if self.dump.as_ref() == Some(&self.eds) {
            let path = self.eds.display();
            return Err(Failure::new(format!(
                "{path} cannot be both; name the EDS file, then the dump"
            )));
        }
        let reading = read_eds(&self.eds)?;
        let recorded = self.recorded(&reading)?;
        mention_own_findings(&reading, &settings);
        let style = self.shown.style();
        let mut printer = Printer::new(style, Subject::Device)?;
        let levels = levels(&settings, recorded.is_log);
        let found = rules::validate(&reading, &recorded.dump, &levels);
        printer.file(style.render(&reading.document, found))?;
        printer.finish()
    }

    /// What the device answered, or answers.
    fn recorded(&self, reading: &Reading) -> Result<Recorded, Failure> {
        match (&self.dump, &self.bus, self.node) {
            (Some(path), ..) => Recorded::read(path, self.node, reading),
            (None, Some(bus), Some(node_id)) => {
                let dump = self.live_dump(bus, node_id, reading)?;
                Ok(Recorded { dump, is_log: false })
            }
            (None, ..) => Err(Failure::new("name a dump, or a bus and a node")),
        }
    }

    fn live_dump(&self, bus: &str, node_id: NodeId, reading: &Reading) -> Result<Dump, Failure> {
        let node_id = ir::NodeId::new(node_id.get()).ok_or_else(|| Failure::new("a node-ID is 1 to 127"))?;
        let order = Order::every_value(&reading.dictionary);
        take_for_validation(&mut self.live.open(bus)?, node_id, order, !self.shown.style().quiet)
    }
}

/// A file that describes something: held against nothing, every device would differ.
pub(super) fn read_eds(path: &Path) -> Result<Reading, Failure> {
    let input = Input::new(path);
    let name = input.name();
    let bytes = input.read()?;
    if is_json(&bytes) {
        return Err(Failure::new(format!(
            "{name} is JSON, not an EDS; the EDS file comes first, then the dump"
        )));
    }
    let reading = lexican_eds::read(name.clone(), bytes);
    let is_foreign = matches!(reading.document.problems(), [Problem::NotCanopen { .. }, ..]);
    if is_foreign || reading.dictionary.objects.is_empty() {
        return Err(Failure::new(format!(
            "{name} describes no object; `lexican check {name}` says what it is"
        )));
    }
    Ok(reading)
}

fn is_json(bytes: &[u8]) -> bool {
    let text = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    text.trim_ascii_start().first() == Some(&b'{')
}

/// The rule that finds what nobody asked for: of a log it is silent, unless the user wants to hear it.
const UNREAD_OBJECT: &str = "DMP012";

fn levels(settings: &Settings, is_log: bool) -> Levels {
    let silence = LevelChange::new(UNREAD_OBJECT, Level::Allow).ok().filter(|_| is_log);
    let levels = silence.map_or_else(Levels::default, |change| Levels::default().with(change));
    levels.then(settings.levels.clone())
}

fn node_id(number: &str) -> Result<NodeId, &'static str> {
    let node_id = number.parse().ok().and_then(NodeId::new);
    node_id.ok_or("a node-ID is a number from 1 to 127")
}

/// A file that is wrong itself makes wrong differences.
fn mention_own_findings(reading: &Reading, settings: &Settings) {
    let found = settings.check(reading);
    let errors = found
        .iter()
        .filter(|diagnostic| diagnostic.level == Level::Deny)
        .count();
    if errors > 0 {
        let (name, count) = (reading.document.source().name(), render::count(Level::Deny, errors));
        failure::note(&format!("{name} itself has {count}; `lexican check {name}` shows them"));
    }
}
