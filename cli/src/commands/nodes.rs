//! Which file describes which node: `--eds FILE[@NODE]`.

use std::{path::PathBuf, str::FromStr};

use lexican_bus::decode::{Decoder, Description};
use lexican_eds::document::Problem;
use lexican_runtime::NodeId;

use crate::{failure::Failure, input::Input};

/// A file, and the node that it describes if that was said.
#[derive(Clone, Debug)]
pub(crate) struct DescribedNode {
    file: PathBuf,
    node_id: Option<NodeId>,
}

impl FromStr for DescribedNode {
    type Err = String;

    /// `pump.eds@5`; an `@` that no number follows is of the file's name.
    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.rsplit_once('@');
        let numbered =
            parts.filter(|(_, number)| !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit()));
        let Some((file, number)) = numbered else {
            return Ok(Self {
                file: text.into(),
                node_id: None,
            });
        };
        let node_id = number.parse().ok().and_then(NodeId::new);
        Ok(Self {
            file: file.into(),
            node_id: Some(node_id.ok_or("a node-ID is a number from 1 to 127")?),
        })
    }
}

/// What is known of the nodes of a bus before anything was heard of them.
#[derive(Debug, Default)]
pub(crate) struct Nodes {
    named: Vec<(NodeId, Description)>,
    default: Option<Description>,
}

impl Nodes {
    /// Reads the files.
    pub(crate) fn read(files: &[DescribedNode]) -> Result<Self, Failure> {
        let mut nodes = Self::default();
        for file in files {
            nodes.add(file)?;
        }
        Ok(nodes)
    }

    fn add(&mut self, described: &DescribedNode) -> Result<(), Failure> {
        let input = Input::new(&described.file);
        let reading = lexican_eds::read(input.name(), input.read()?);
        let is_foreign = matches!(reading.document.problems(), [Problem::NotCanopen { .. }, ..]);
        if is_foreign || reading.dictionary.objects.is_empty() {
            let name = input.name();
            return Err(Failure::new(format!(
                "{name} describes no object; `lexican check {name}` says what it is"
            )));
        }
        let commissioned = reading.dictionary.commissioning.as_ref();
        let commissioned = commissioned
            .and_then(|it| it.node_id)
            .and_then(|it| NodeId::new(it.get()));
        let description = Description::new(&reading.dictionary);
        match described.node_id.or(commissioned) {
            Some(node_id) if self.named.iter().any(|(known, _)| *known == node_id) => {
                let number = node_id.get();
                return Err(Failure::new(format!(
                    "two files describe node {number}; say which node each is of: --eds FILE@NODE"
                )));
            }
            Some(node_id) => self.named.push((node_id, description)),
            None if self.default.is_some() => {
                return Err(Failure::new(
                    "two files describe all nodes; say which node each is of: --eds FILE@NODE",
                ));
            }
            None => self.default = Some(description),
        }
        Ok(())
    }

    /// A bus with these nodes.
    pub(crate) fn decoder(&self) -> Decoder<'_> {
        let mut decoder = Decoder::new(self.default.as_ref());
        for (node_id, description) in &self.named {
            decoder.describe(*node_id, description);
        }
        decoder
    }
}
