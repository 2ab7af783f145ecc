//! Which devices are on the bus, and how their values are changed.

use std::{
    collections::BTreeSet,
    fmt,
    path::{Path, PathBuf},
    str::FromStr,
};

use lexican_bus::simulated::{Memory, Network, Simulated, complete};
use lexican_eds::ir::{self, Dictionary};
use lexican_runtime::{AbortCode, Address, Node, NodeId, od};

use super::script::Assignment;
use crate::{
    failure::{self, Failure},
    input::Input,
};

/// How much a simulated device stores, in bytes.
const MEMORY: usize = 0x1_0000;

/// Node-IDs in the order in which they were given.
#[derive(Clone, Debug)]
pub(crate) struct Ids(Vec<NodeId>);

impl FromStr for Ids {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut ids = Vec::new();
        for part in text.split(',') {
            let (first, last) = part.split_once("..").unwrap_or((part, part));
            let (first, last) = (node_id(first)?, node_id(last.trim_start_matches('='))?);
            if first > last {
                return Err(format!("`{part}` runs backwards"));
            }
            ids.extend((first.get()..=last.get()).filter_map(NodeId::new));
        }
        if ids.iter().collect::<BTreeSet<_>>().len() < ids.len() {
            return Err("a node-ID is there twice".into());
        }
        Ok(Self(ids))
    }
}

/// 1 to 127, decimal.
pub(super) fn node_id(text: &str) -> Result<NodeId, String> {
    let number = text.trim().parse().ok().and_then(NodeId::new);
    number.ok_or_else(|| format!("`{text}` is no node-ID; these are 1 to 127"))
}

/// The simulated devices, with the files that they are made of.
pub(super) struct Nodes {
    pub(super) network: Network,
    /// In the order of the network's nodes: the node-ID at the start, and which file.
    made_of: Vec<(NodeId, usize)>,
    files: Vec<(String, Dictionary)>,
}

impl Nodes {
    /// Reads the files and makes the devices.
    pub(super) fn read(paths: &[PathBuf], ids: Option<&Ids>) -> Result<Self, Failure> {
        let files = paths.iter().map(|path| read(path)).collect::<Result<Vec<_>, _>>()?;
        let made_of = assign(&files, ids)?;
        let devices: Vec<Simulated> = files.iter().map(device).collect();
        let mut network = Network::default();
        for (id, file) in &made_of {
            let memory = Memory::flash(MEMORY);
            let device = devices.get(*file).cloned().map(|device| device.with_memory(&memory));
            network.extend(device.map(|device| Node::new(device, *id)));
        }
        Ok(Self {
            network,
            made_of,
            files,
        })
    }

    /// Carries out what `--set` says.
    pub(super) fn set(&mut self, assignments: &[String]) -> Result<(), Failure> {
        for text in assignments {
            let done = text.parse().and_then(|assignment| self.assign(&assignment));
            done.map_err(|reason| Failure::new(format!("--set {text}: {reason}")))?;
        }
        Ok(())
    }

    /// Gives the object its value in all nodes that are meant; says why when that is none.
    pub(super) fn assign(&mut self, assignment: &Assignment) -> Result<(), String> {
        let values = self.values(assignment)?;
        for (node, value) in self.network.nodes_mut().iter_mut().zip(values) {
            if let Some(value) = value {
                change(node, assignment.address, &value).map_err(|code| refused(assignment, code))?;
            }
        }
        Ok(())
    }

    /// The bytes that each node is to be given, `None` for those that are not meant.
    pub(super) fn values(&self, assignment: &Assignment) -> Result<Vec<Option<Vec<u8>>>, String> {
        let nodes = self.network.nodes().iter().zip(&self.made_of);
        let meant = nodes.map(|(node, (id, file))| {
            let id = node.node_id().unwrap_or(*id);
            let is_meant = assignment.node_id.is_none_or(|meant| meant == id);
            let (_, dictionary) = self.files.get(*file).filter(|_| is_meant)?;
            let address = ir::Address::new(assignment.address.index, assignment.address.sub);
            Some(assignment.bytes(dictionary.entry(address)?.data_type, id))
        });
        let values: Vec<_> = meant.map(Option::transpose).collect::<Result<_, _>>()?;
        if values.iter().all(Option::is_none) {
            return Err(format!(
                "no {} has the object {}",
                Who(assignment.node_id),
                assignment.object()
            ));
        }
        Ok(values)
    }

    /// Says on stderr who is there, consecutive nodes of one file in one line.
    pub(super) fn announce(&self) {
        let mut rest = self.made_of.as_slice();
        while let Some((first, file)) = rest.first().copied() {
            let run = (0_u8..)
                .zip(rest)
                .take_while(|(step, (id, of))| *of == file && first.get().checked_add(*step) == Some(id.get()));
            let count = run.count();
            let Some((name, dictionary)) = self.files.get(file) else {
                return;
            };
            let last = rest.get(count - 1).map_or(first, |(id, _)| *id);
            let ids = if count == 1 {
                format!("node {} is", first.get())
            } else {
                format!("nodes {} to {} are", first.get(), last.get())
            };
            let objects = dictionary.objects.len();
            failure::note(&format!("{ids} {name}, {objects} objects"));
            rest = rest.get(count..).unwrap_or_default();
        }
    }
}

/// Whom an assignment is for, in a message.
struct Who(Option<NodeId>);

impl fmt::Display for Who {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(id) => write!(f, "node {}", id.get()),
            None => f.write_str("node"),
        }
    }
}

fn refused(assignment: &Assignment, code: AbortCode) -> String {
    let code = lexican_eds::dump::AbortCode(code.0);
    format!("{} refuses the value: {code}", assignment.object())
}

/// What a client may write is written as by a client, with its effects on the services; the rest as the application does it.
fn change(node: &mut Node<Simulated>, address: Address, value: &[u8]) -> Result<(), AbortCode> {
    match node.write(address, value) {
        Err(AbortCode::READ_ONLY) => od::set(node.device_mut(), address, value)?,
        result => result?,
    }
    node.object_changed(address);
    Ok(())
}

fn read(path: &Path) -> Result<(String, Dictionary), Failure> {
    let input = Input::new(path);
    let name = input.name();
    let dictionary = lexican_eds::read(name.clone(), input.read()?).dictionary;
    if dictionary.objects.is_empty() {
        return Err(Failure::new(format!(
            "{name} describes no object; `lexican check {name}` says what it is"
        )));
    }
    Ok((name, dictionary))
}

fn device((name, dictionary): &(String, Dictionary)) -> Simulated {
    let device = Simulated::of(&complete(dictionary));
    let left_out = device.left_out().len();
    if left_out > 0 {
        failure::note(&format!(
            "{name}: {left_out} values are beyond the 64 KiB of a dictionary, or there twice; the device is without them"
        ));
    }
    device
}

/// Which file each node is made of.
fn assign(files: &[(String, Dictionary)], ids: Option<&Ids>) -> Result<Vec<(NodeId, usize)>, Failure> {
    match ids {
        None => choose(files),
        Some(Ids(ids)) if files.len() == 1 => Ok(ids.iter().map(|id| (*id, 0)).collect()),
        Some(Ids(ids)) if files.len() == ids.len() => Ok(ids.iter().copied().zip(0..).collect()),
        Some(Ids(ids)) => Err(Failure::new(format!(
            "{} files and {} node-IDs; give each file one, or one file any number",
            files.len(),
            ids.len()
        ))),
    }
}

/// The node-IDs of the DCF files, and the lowest free ones for the rest.
fn choose(files: &[(String, Dictionary)]) -> Result<Vec<(NodeId, usize)>, Failure> {
    let own = |dictionary: &Dictionary| NodeId::new(dictionary.commissioning.as_ref()?.node_id?.get());
    let mut taken: BTreeSet<NodeId> = BTreeSet::new();
    let wanted: Vec<_> = files
        .iter()
        .map(|(_, dictionary)| own(dictionary).filter(|id| taken.insert(*id)))
        .collect();
    let mut free = (1..=127).filter_map(NodeId::new).filter(|id| !taken.contains(id));
    let chosen = wanted.into_iter().map(|id| id.or_else(|| free.next())).zip(0..);
    chosen
        .map(|(id, file)| Some((id?, file)))
        .collect::<Option<_>>()
        .ok_or_else(|| Failure::new("a bus has 127 nodes at most"))
}
