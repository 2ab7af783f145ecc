//! Several simulated nodes on one bus.

use lexican_runtime::{Frame, Instant, Node, NodeId};

use super::Simulated;

/// Nodes that share a bus: what one sends the others receive, as they receive what comes from outside.
///
/// As sans-IO as a [`Node`]: frames and the time are handed in, [`Network::poll`] says what goes out.
#[derive(Clone, Debug, Default)]
pub struct Network {
    nodes: Vec<Node<Simulated>>,
    /// Whose turn it is to send.
    turn: usize,
}

impl Network {
    /// Puts a node on the bus, which will boot up. Two with the same node-ID answer both, as they do on a real bus.
    pub fn join(&mut self, node: Node<Simulated>) {
        self.nodes.push(node);
    }

    /// Hands each node a frame from outside.
    pub fn receive(&mut self, now: Instant, frame: &Frame) {
        for node in &mut self.nodes {
            node.receive(now, frame);
        }
    }

    /// The next frame that a node sends at `now`, which the other nodes have received when it is given; `None` when there is
    /// nothing (more) to say. The nodes take turns.
    pub fn poll(&mut self, now: Instant) -> Option<Frame> {
        let count = self.nodes.len();
        let (sender, frame) = (0..count).find_map(|step| {
            let number = (self.turn + step) % count;
            let frame = self.nodes.get_mut(number)?.poll(now)?;
            Some((number, frame))
        })?;
        self.turn = (sender + 1) % count;
        for (number, node) in self.nodes.iter_mut().enumerate() {
            if number != sender {
                node.receive(now, &frame);
            }
        }
        Some(frame)
    }

    /// When [`Network::poll`] is to be called next, if no frame arrives before; `None` when nothing will ever be due.
    #[must_use]
    pub fn poll_at(&self) -> Option<Instant> {
        self.nodes.iter().filter_map(Node::poll_at).min()
    }

    /// The nodes, in the order of joining.
    #[must_use]
    pub fn nodes(&self) -> &[Node<Simulated>] {
        &self.nodes
    }

    /// The same, to change them.
    pub fn nodes_mut(&mut self) -> &mut [Node<Simulated>] {
        &mut self.nodes
    }

    /// The node that has this node-ID now; LSS may have given it another than it joined with.
    pub fn node(&mut self, node_id: NodeId) -> Option<&mut Node<Simulated>> {
        self.nodes.iter_mut().find(|node| node.node_id() == Some(node_id))
    }
}

impl Extend<Node<Simulated>> for Network {
    fn extend<I: IntoIterator<Item = Node<Simulated>>>(&mut self, nodes: I) {
        self.nodes.extend(nodes);
    }
}
